/*
 * Runs a WebAssembly program like one of this machine: its arguments, files and exit status.
 *
 *   node --no-warnings run_wasm.js PROGRAM ARGUMENT...      (node warns that WASI is experimental)
 *
 * A program sees no directory but those that it is given. Here that is "/", so that absolute paths
 * are what they are everywhere; relative ones begin at "/" as well, for WASI has no working
 * directory. Giving it "." too does not help: wasi-libc then looks for all of them there.
 */
"use strict";

/* Otherwise garbage collection in the middle of a system call ends node (nodejs/node#46777). */
require("node:v8").setFlagsFromString("--no-turbo-fast-api-calls");

const fs = require("node:fs");
const { WASI } = require("node:wasi");

const [program, ...rest] = process.argv.slice(2);
const wasi = new WASI({ version: "preview1", args: [program, ...rest], preopens: { "/": "/" } });
const wasm = new WebAssembly.Module(fs.readFileSync(program));
const instance = new WebAssembly.Instance(wasm, { wasi_snapshot_preview1: wasi.wasiImport });
process.exitCode = wasi.start(instance);
