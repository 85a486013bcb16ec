/* A page of HTML that shows scenes: see page.h. */
#include "page.h"

#include "base64.h"
#include "png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The colours are those of the lessons' charts. */
static const char *const style[] = {
    ":root{color-scheme:light dark;--text:#1f2328;--paper:#fff;--line:#d1d9e0;--soft:#f6f8fa;",
    "--mark:#0a5cc2}",
    "@media (prefers-color-scheme:dark){:root{--text:#e6edf3;--paper:#0d1117;--line:#3d444d;",
    "--soft:#151b23;--mark:#58a6ff}}",
    "*{box-sizing:border-box}",
    "body{margin:0;background:var(--paper);color:var(--text);font:16px/1.4 sans-serif}",
    "header{position:sticky;top:0;z-index:1;background:var(--paper);padding:8px 16px;",
    "border-bottom:1px solid var(--line);display:flex;flex-wrap:wrap;gap:8px;align-items:center}",
    "h1{font-size:18px;margin:0 12px 0 0}h2{font-size:16px;margin:16px 0 4px}",
    "main{padding:0 16px 72px}p{margin:4px 0;overflow-wrap:anywhere}",
    "button{font:inherit;color:inherit;background:var(--soft);border:1px solid var(--line);",
    "border-radius:6px;padding:4px 10px;cursor:pointer}",
    "button[aria-pressed=true]{border-color:var(--mark);color:var(--mark)}",
    ":focus-visible{outline:3px solid var(--mark);outline-offset:1px}",
    ".pictures{display:flex;gap:8px;align-items:flex-start}",
    "figure{margin:0;flex:1 1 0;min-width:0}",
    ".view{overflow:auto;max-height:calc(100vh - 170px);border:1px solid var(--line);",
    "background:var(--soft)}",
    "img{display:block;image-rendering:pixelated;max-width:none}",
    "body:not(.js) img{width:100%;height:auto}",
    "figcaption{font-size:14px;padding:2px 0}",
    "body.single .pictures figure{display:none}",
    "body.single .pictures figure.shown{display:block}",
    "#values{position:fixed;left:0;right:0;bottom:0;background:var(--soft);padding:6px 16px;",
    "border-top:1px solid var(--line);font:14px/1.4 monospace;min-height:32px}",
    "kbd{border:1px solid var(--line);border-radius:4px;padding:0 4px;font-size:13px}",
    "details{margin:8px 0}a{color:var(--mark)}pre{overflow:auto;font-size:13px}",
    "th,td{text-align:left;padding:2px 12px 2px 0;vertical-align:top}",
    "@media (max-width:700px){body:not(.single) .pictures{flex-direction:column}",
    "body:not(.single) figure{width:100%;flex:none}}",
    NULL};

static const char *const controls[] = {
    "<button id=side aria-pressed=true>side by side</button>\n",
    "<button id=yours aria-pressed=false>yours</button>\n",
    "<button id=reference aria-pressed=false>reference</button>\n",
    "<button id=difference aria-pressed=false>difference</button>\n",
    "<button id=smaller aria-label=smaller>&minus;</button>\n",
    "<output id=zoom>fit</output>\n",
    "<button id=larger aria-label=larger>+</button>\n",
    NULL};

static const char *const legend[] = {
    "<details><summary>Keys and colours</summary>\n",
    "<p><kbd>s</kbd> side by side, <kbd>y</kbd> yours, <kbd>r</kbd> reference, <kbd>d</kbd> ",
    "difference, <kbd>space</kbd> yours and reference in turn, <kbd>+</kbd> <kbd>-</kbd> larger ",
    "and smaller, <kbd>n</kbd> <kbd>p</kbd> next and previous scene.</p>\n",
    "<p>In the difference, red: this pixel of yours should not be there, or has another colour; ",
    "blue: missing; dark green: differs, but does not count.</p>\n",
    "</details>\n",
    NULL};

/* Zoom 0 fits the picture into its column: a small one a whole number of times as large. */
static const char *const script[] = {
    "'use strict';\n",
    "const names=['yours','reference','difference'],byId=id=>document.getElementById(id);\n",
    "const figures=[...document.querySelectorAll('figure')];\n",
    "const zooms=[0,1,2,4,8,16,32];let zoom=0,mode='side';\n",
    "document.body.classList.add('js');\n",
    "function fit(figure){\n",
    " const img=figure.querySelector('img'),w=img.naturalWidth;\n",
    " const room=figure.clientWidth-2;let width=w*zooms[zoom];\n",
    " if(!width)width=w>room?room:w*Math.max(1,Math.floor(Math.min(room,800)/w));\n",
    " img.style.width=width+'px';img.style.height='auto';\n",
    " img.style.imageRendering=width<w?'auto':'pixelated';\n",
    "}\n",
    "function update(){\n",
    " document.body.classList.toggle('single',mode!='side');\n",
    " for(const f of figures)f.classList.toggle('shown',f.dataset.name==mode);\n",
    " for(const id of ['side',...names])byId(id).setAttribute('aria-pressed',mode==id);\n",
    " byId('zoom').textContent=zoom?zooms[zoom]+'x':'fit';\n",
    " for(const f of figures)if(f.clientWidth)fit(f);\n",
    "}\n",
    "function choose(name){mode=name;update();}\n",
    "function resize(by){\n",
    " zoom=Math.min(zooms.length-1,Math.max(0,zoom+by));update();\n",
    "}\n",
    "function jump(by){\n",
    " const all=[...document.querySelectorAll('section')],top=byId('top').offsetHeight+4;\n",
    " let at=all.findIndex(s=>s.getBoundingClientRect().bottom>top+20);\n",
    " at=Math.min(all.length-1,Math.max(0,(at<0?all.length-1:at)+by));\n",
    " scrollTo(0,all[at].offsetTop-top);\n",
    "}\n",
    "for(const id of ['side',...names])byId(id).onclick=()=>choose(id);\n",
    "byId('smaller').onclick=()=>resize(-1);byId('larger').onclick=()=>resize(1);\n",
    "const keys={s:()=>choose('side'),y:()=>choose('yours'),r:()=>choose('reference'),\n",
    " d:()=>choose('difference'),' ':()=>choose(mode=='yours'?'reference':'yours'),\n",
    " '+':()=>resize(1),'=':()=>resize(1),'-':()=>resize(-1),n:()=>jump(1),p:()=>jump(-1)};\n",
    "document.addEventListener('keydown',e=>{\n",
    " if(e.ctrlKey||e.altKey||e.metaKey||!keys[e.key])return;\n",
    " if(e.key==' '&&/^(BUTTON|SUMMARY)$/.test(e.target.tagName))return;\n",
    " keys[e.key]();e.preventDefault();\n",
    "});\n",
    "/* The three pictures of a scene are scrolled together. */\n",
    "document.addEventListener('scroll',e=>{\n",
    " const view=e.target;if(!view.classList||!view.classList.contains('view'))return;\n",
    " for(const other of view.closest('section').querySelectorAll('.view')){\n",
    "  if(other.scrollLeft!=view.scrollLeft)other.scrollLeft=view.scrollLeft;\n",
    "  if(other.scrollTop!=view.scrollTop)other.scrollTop=view.scrollTop;\n",
    " }\n",
    "},true);\n",
    "const pixels=new Map();\n",
    "function pixelsOf(img){\n",
    " if(!pixels.has(img)){\n",
    "  const canvas=document.createElement('canvas');\n",
    "  canvas.width=img.naturalWidth;canvas.height=img.naturalHeight;\n",
    "  const context=canvas.getContext('2d',{willReadFrequently:true});\n",
    "  context.drawImage(img,0,0);pixels.set(img,context);\n",
    " }\n",
    " return pixels.get(img);\n",
    "}\n",
    "/* Rows count from the bottom, as in the course. */\n",
    "document.addEventListener('mousemove',e=>{\n",
    " const img=e.target;if(img.tagName!='IMG'){return;}\n",
    " const box=img.getBoundingClientRect(),h=img.naturalHeight;\n",
    " const x=Math.floor((e.clientX-box.left)/box.width*img.naturalWidth);\n",
    " const y=Math.floor((e.clientY-box.top)/box.height*h);\n",
    " let text='('+x+','+(h-1-y)+')';\n",
    " for(const f of img.closest('section').querySelectorAll('figure')){\n",
    "  const other=f.querySelector('img'),up=h-1-y;\n",
    "  if(f.dataset.name=='difference'||x>=other.naturalWidth||up>=other.naturalHeight)continue;\n",
    "  const value=pixelsOf(other).getImageData(x,other.naturalHeight-1-up,1,1).data;\n",
    "  text+='  '+f.dataset.name+' '+value[0]+','+value[1]+','+value[2];\n",
    " }\n",
    " byId('values').textContent=text;\n",
    "});\n",
    "document.addEventListener('toggle',update,true);\n",
    "addEventListener('resize',update);addEventListener('load',update);update();\n",
    NULL};

static bool put_all(struct bytes *page, const char *const *lines) {
    for (size_t i = 0; lines[i] != NULL; i++) {
        if (!page_html(page, lines[i])) {
            return false;
        }
    }
    return true;
}

bool page_html(struct bytes *page, const char *html) {
    return bytes_append(page, html, strlen(html));
}

/* What stands for a character that HTML would read as its own, or NULL. */
static const char *entity_of(char character) {
    switch (character) {
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '&':
        return "&amp;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return NULL;
    }
}

bool page_text(struct bytes *page, const char *text) {
    char *printable = string_format("%s", text);
    bool done = printable != NULL;
    if (done) {
        text_make_printable(printable, '?');
    }
    for (const char *at = printable; done && *at != '\0'; at++) {
        const char *entity = entity_of(*at);
        done = entity != NULL ? page_html(page, entity) : bytes_append(page, at, 1);
    }
    free(printable);
    return done;
}

bool page_begin(struct bytes *page, const char *title) {
    return page_html(page, "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
                           "<meta name=viewport content=\"width=device-width,initial-scale=1\">\n"
                           "<link rel=icon href=\"data:,\">\n<title>") &&
           page_text(page, title) && page_html(page, "</title>\n<style>\n") &&
           put_all(page, style) &&
           page_html(page, "\n</style>\n</head>\n<body>\n<header id=top>\n<h1>") &&
           page_text(page, title) && page_html(page, "</h1>\n") && put_all(page, controls) &&
           page_html(page, "</header>\n<main>\n") && put_all(page, legend);
}

/* The picture as the address of an <img>. */
static bool put_image(struct bytes *page, const struct image *image, struct error *error) {
    struct bytes png = {.data = NULL};
    bool encoded = png_encode(image, &png, error);
    bool done = encoded && page_html(page, "data:image/png;base64,") &&
                base64_encode(page, png.data, png.size);
    bytes_free(&png);
    return done || (encoded && error_out_of_memory(error));
}

static bool put_figure(struct bytes *page, const char *scene, const char *name,
                       const struct image *image, struct error *error) {
    bool begun = page_html(page, "<figure data-name=") && page_html(page, name) &&
                 page_html(page, "><figcaption>") && page_html(page, name) &&
                 page_html(page, "</figcaption><div class=view tabindex=0><img alt=\"") &&
                 page_text(page, scene) && page_html(page, ", ") && page_html(page, name) &&
                 page_html(page, "\" src=\"");
    if (!begun) {
        return error_out_of_memory(error);
    }
    return put_image(page, image, error) &&
           (page_html(page, "\"></div></figure>\n") || error_out_of_memory(error));
}

bool page_scene(struct bytes *page, const char *name, const char *note,
                const struct pictures *pictures, struct error *error) {
    bool begun = page_html(page, "<section>\n<h2>") && page_text(page, name) &&
                 page_html(page, "</h2>\n<p>") && page_text(page, note) &&
                 page_html(page, "</p>\n<div class=pictures>\n");
    if (!begun) {
        return error_out_of_memory(error);
    }
    for (int i = 0; i < PICTURE_COUNT; i++) {
        const struct image *image = &pictures->image[i];
        if (image->width > 0 && !put_figure(page, name, picture_names[i], image, error)) {
            return false;
        }
    }
    return page_html(page, "</div>\n</section>\n") || error_out_of_memory(error);
}

bool page_end(struct bytes *page) {
    return page_html(page, "</main>\n<div id=values aria-live=off></div>\n<script>\n") &&
           put_all(page, script) && page_html(page, "</script>\n</body>\n</html>\n");
}
