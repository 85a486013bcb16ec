/* Windows: see run.h. A job object is what a process group is elsewhere, and has its limits. */
#define _POSIX_C_SOURCE 200809L
#include "run.h"

#ifdef _WIN32

#include "base/platform.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>
#include <windows.h>
#undef near /* words of 16-bit pointers, which it still defines away */
#undef far

enum {
    MESSAGE_LIMIT = 256 * 1024, /* bytes of standard error that are kept */
    TICK_MS = 5,                /* between two looks at a running program */
    COMMAND_LIMIT = 32768       /* characters of a command line, which Windows sets */
};

static bool fail(struct error *error, const char *what, const char *name) {
    return error_set(error, "cannot %s %.900s: error %lu of Windows", what, name, GetLastError());
}

/* ---- Starting a program ---- */

/* A line that its program takes apart again, by the rules of Microsoft's C library. */
struct command_line {
    char text[COMMAND_LIMIT];
    size_t length;
};

static void put_char(struct command_line *line, char c) {
    if (line->length + 1 < sizeof line->text) {
        line->text[line->length++] = c;
    }
}

/* Between quotes; backslashes before one are doubled, and it gets its own. */
static void put_argument(struct command_line *line, const char *argument) {
    size_t backslashes = 0;
    put_char(line, '"');
    for (const char *at = argument; *at != '\0'; at++) {
        for (size_t i = *at == '"' ? backslashes + 1 : 0; i > 0; i--) {
            put_char(line, '\\');
        }
        backslashes = *at == '\\' ? backslashes + 1 : 0;
        put_char(line, *at);
    }
    for (; backslashes > 0; backslashes--) {
        put_char(line, '\\');
    }
    put_char(line, '"');
    put_char(line, ' ');
}

/* What a program runs with: it writes to `messages`, one end of a pipe, of which `said` is ours. */
struct handles {
    HANDLE job, input, output, messages, said;
};

static void close_handle(HANDLE handle) {
    if (handle != NULL && handle != INVALID_HANDLE_VALUE) {
        CloseHandle(handle);
    }
}

static HANDLE create_job(const struct run_command *command) {
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits = {
        .BasicLimitInformation = {.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE |
                                                JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION,
                                  .ActiveProcessLimit = command->limits.processes},
        .ProcessMemoryLimit = command->limits.memory_bytes,
        .JobMemoryLimit = command->limits.group_bytes};
    limits.BasicLimitInformation.LimitFlags |=
        (command->contained ? JOB_OBJECT_LIMIT_ACTIVE_PROCESS : 0) |
        (command->limits.memory_bytes > 0 ? JOB_OBJECT_LIMIT_PROCESS_MEMORY : 0) |
        (command->limits.group_bytes > 0 ? JOB_OBJECT_LIMIT_JOB_MEMORY : 0);
    HANDLE job = CreateJobObjectW(NULL, NULL);
    SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
    return job;
}

static bool open_handles(struct handles *handles, const struct run_command *command,
                         struct error *error) {
    SECURITY_ATTRIBUTES inherited = {.nLength = sizeof inherited, .bInheritHandle = TRUE};
    const char *output = command->output == NULL ? "NUL" : command->output;
    *handles = (struct handles){.job = create_job(command)};
    handles->input = CreateFileW(L"NUL", GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                 &inherited, OPEN_EXISTING, 0, NULL);
    handles->output =
        CreateFileW(windows_widen(output).path, GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                    &inherited, command->output == NULL ? OPEN_EXISTING : CREATE_NEW, 0, NULL);
    if (handles->job == NULL || handles->input == INVALID_HANDLE_VALUE ||
        handles->output == INVALID_HANDLE_VALUE) {
        return fail(error, "open", output);
    }
    return (CreatePipe(&handles->said, &handles->messages, &inherited, MESSAGE_LIMIT) &&
            SetHandleInformation(handles->said, HANDLE_FLAG_INHERIT, 0)) ||
           fail(error, "make", "a pipe");
}

/* Start the program, already in its job. NULL where it cannot be. */
static HANDLE start(const struct run_command *command, const struct handles *handles) {
    struct command_line line = {.length = 0};
    for (size_t i = 0; command->arguments[i] != NULL; i++) {
        put_argument(&line, command->arguments[i]);
    }
    wchar_t wide[COMMAND_LIMIT];
    STARTUPINFOW with = {.cb = sizeof with,
                         .dwFlags = STARTF_USESTDHANDLES,
                         .hStdInput = handles->input,
                         .hStdOutput = handles->output,
                         .hStdError = handles->messages};
    PROCESS_INFORMATION started = {.hProcess = NULL};
    if (command->locale != NULL) { /* ours too from now on: the check has no other language */
        SetEnvironmentVariableA("LC_ALL", command->locale);
    }
    /* No window asks what to do about a program that has crashed. */
    SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
    const char *directory = command->directory == NULL ? "." : command->directory;
    if (MultiByteToWideChar(CP_UTF8, 0, line.text, -1, wide, COMMAND_LIMIT) > 0 &&
        CreateProcessW(NULL, wide, NULL, NULL, TRUE, CREATE_SUSPENDED, NULL,
                       windows_widen(directory).path, &with, &started)) {
        AssignProcessToJobObject(handles->job, started.hProcess);
        ResumeThread(started.hThread);
        CloseHandle(started.hThread);
    }
    return started.hProcess;
}

/* ---- Waiting for it ---- */

/* Read what has come, at most one buffer; false when nothing has. */
static bool read_messages(HANDLE said, struct bytes *messages) {
    char buffer[65536];
    DWORD there = 0, length = 0;
    if (!PeekNamedPipe(said, NULL, 0, NULL, &there, NULL) || there == 0 ||
        !ReadFile(said, buffer, sizeof buffer, &length, NULL)) {
        return false;
    }
    size_t room = MESSAGE_LIMIT - messages->size;
    bytes_append(messages, buffer, length < room ? length : room);
    return true;
}

static enum run_end watch(const struct run_command *command, HANDLE process,
                          const struct handles *handles, struct bytes *messages) {
    double end = run_now() + command->limits.seconds;
    while (WaitForSingleObject(process, TICK_MS) == WAIT_TIMEOUT) {
        if (run_caught_signal() != 0) {
            return RUN_INTERRUPTED;
        }
        if (run_now() > end) {
            return RUN_OUT_OF_TIME;
        }
        read_messages(handles->said, messages);
    }
    return RUN_EXITED;
}

/* The signal by which the program would have ended elsewhere; 0: it has ended by itself. */
static int signal_of(DWORD status) {
    enum { ABORTED = 3, SEVERE = 0xC /* the first digit of what Windows calls an error */ };
    return status == ABORTED                         ? SIGABRT
           : status == STATUS_INTEGER_DIVIDE_BY_ZERO ? SIGFPE
           : status == STATUS_ILLEGAL_INSTRUCTION    ? SIGILL
           : status >> 28 == SEVERE                  ? SIGSEGV
                                                     : 0;
}

/* Without NULs, since a text ends at its first, and the CR of Windows' lines. */
static void clean(struct bytes *messages) {
    size_t length = 0;
    for (size_t i = 0; i < messages->size; i++) {
        unsigned char c = messages->data[i];
        messages->data[length] = c == '\0' ? ' ' : c;
        length += c != '\r';
    }
    messages->size = length;
}

/* Wait for the program, and end what it leaves. */
static bool wait_for_end(const struct run_command *command, HANDLE process,
                         const struct handles *handles, struct run_result *result) {
    DWORD status = 0;
    result->end = watch(command, process, handles, &result->messages);
    TerminateJobObject(handles->job, 1);
    WaitForSingleObject(process, INFINITE);
    GetExitCodeProcess(process, &status);
    while (read_messages(handles->said, &result->messages)) {
    }
    clean(&result->messages);
    result->number = (int)status;
    if (result->end == RUN_EXITED && command->contained && signal_of(status) != 0) {
        result->end = RUN_KILLED;
        result->number = signal_of(status);
    }
    return bytes_append(&result->messages, "", 1);
}

bool run(const struct run_command *command, struct run_result *result, struct error *error) {
    *result = (struct run_result){.end = RUN_EXITED};
    const char *runner = getenv("CHECK_RUNNER");
    if (command->contained && runner != NULL && runner[0] != '\0') {
        return error_set(error, "CHECK_RUNNER does not shut programs in on Windows");
    }
    struct handles handles;
    bool done = open_handles(&handles, command, error);
    HANDLE process = done ? start(command, &handles) : NULL;
    close_handle(handles.messages); /* only the program has it now */
    if (process != NULL) {
        done = wait_for_end(command, process, &handles, result) || error_out_of_memory(error);
    } else if (done) {
        done = fail(error, "start", command->arguments[0]);
    }
    close_handle(process);
    close_handle(handles.input);
    close_handle(handles.output);
    close_handle(handles.said);
    close_handle(handles.job); /* ends whoever is left in it */
    return done;
}

/* ---- Files and directories ---- */

bool run_open_standard_files(void) {
    return true; /* numbers of files are the C library's own here */
}

bool run_lock(const char *path, const char *busy, struct error *error) {
    enum { AGAIN_MS = 200 };
    const char *said = busy;
    /* Open until this process ends: nobody else can open it meanwhile. */
    while (CreateFileW(windows_widen(path).path, GENERIC_WRITE, 0, NULL, OPEN_ALWAYS, 0, NULL) ==
           INVALID_HANDLE_VALUE) {
        if (GetLastError() != ERROR_SHARING_VIOLATION) {
            return fail(error, "write", path);
        }
        fputs(said, stderr);
        said = "";
        Sleep(AGAIN_MS);
    }
    return true;
}

const char *run_temporary(void) {
    static char path[RUN_PATH_LIMIT];
    wchar_t wide[RUN_PATH_LIMIT / 4];
    bool found = GetTempPathW(RUN_PATH_LIMIT / 4, wide) > 0 &&
                 WideCharToMultiByte(CP_UTF8, 0, wide, -1, path, sizeof path, NULL, NULL) > 0;
    return found ? path : ".";
}

bool run_has_room(const char *directory, size_t bytes, struct error *error) {
    ULARGE_INTEGER there;
    return !GetDiskFreeSpaceExW(windows_widen(directory).path, &there, NULL, NULL) ||
           there.QuadPart >= bytes || error_set(error, "%.900s: %s", directory, strerror(ENOSPC));
}

bool run_directory_create(struct run_directory *directory, struct error *error) {
    static unsigned number;
    const char *parent = run_temporary();
    snprintf(directory->path, sizeof directory->path, "%.1900scheck.%lu.%u", parent,
             GetCurrentProcessId(), number++);
    return windows_mkdir(directory->path) == 0 || fail(error, "make", directory->path);
}

/* The file, the link, or the directory with everything in it. */
static void remove_all(const wchar_t *path) {
    struct windows_wide inside;
    WIN32_FIND_DATAW found;
    DWORD is = GetFileAttributesW(path);
    bool enters = (is & FILE_ATTRIBUTE_DIRECTORY) != 0 && (is & FILE_ATTRIBUTE_REPARSE_POINT) == 0;
    swprintf(inside.path, WINDOWS_PATH, L"%ls/*", path);
    HANDLE list = enters ? FindFirstFileW(inside.path, &found) : INVALID_HANDLE_VALUE;
    for (bool more = list != INVALID_HANDLE_VALUE; more; more = FindNextFileW(list, &found)) {
        if (wcscmp(found.cFileName, L".") != 0 && wcscmp(found.cFileName, L"..") != 0) {
            swprintf(inside.path, WINDOWS_PATH, L"%ls/%ls", path, found.cFileName);
            remove_all(inside.path);
        }
    }
    FindClose(list);
    if ((is & FILE_ATTRIBUTE_DIRECTORY) != 0) {
        RemoveDirectoryW(path);
    } else {
        DeleteFileW(path);
    }
}

void run_directory_remove(const char *path) {
    remove_all(windows_widen(path).path);
}

#endif
