/*
 * sh.exe for wine: calls the sh of Linux, so that a program of Windows can call make. Wine hands
 * over neither pipes nor an exit status: they go through files that begin with the path SAID of
 * the environment.
 */
#include <stdio.h>
#include <stdlib.h>

#ifdef _WIN32

#include <windows.h>

/* Waits for the file, and removes it when all of it is in the buffer. */
static void take(char *buffer, size_t size, const char *said, const char *ending) {
    enum { TICK_MS = 20 };
    char path[MAX_PATH];
    FILE *file;
    snprintf(path, sizeof path, "%s.%s", said, ending);
    while ((file = fopen(path, "rb")) == NULL) {
        Sleep(TICK_MS);
    }
    buffer[fread(buffer, 1, size - 1, file)] = '\0';
    fclose(file);
    remove(path);
}

int main(void) {
    enum { LIMIT = 1 << 20 };
    static char text[LIMIT];
    const char *said = getenv("SAID"), *arguments = GetCommandLineA();
    STARTUPINFOA with = {.cb = sizeof with};
    PROCESS_INFORMATION started;
    while (*arguments != ' ' && *arguments != '\0') { /* our name */
        arguments++;
    }
    snprintf(text, sizeof text,
             "Z:\\bin\\sh -c \"sh \\\"$@\\\" >$SAID.text 2>&1; echo $? >$SAID.new; mv $SAID.new "
             "$SAID.status\" sh%s",
             arguments);
    if (said == NULL ||
        !CreateProcessA(NULL, text, NULL, NULL, TRUE, 0, NULL, NULL, &with, &started)) {
        return EXIT_FAILURE;
    }
    char status[8];
    take(status, sizeof status, said, "status");
    take(text, sizeof text, said, "text");
    fputs(text, stderr);
    return atoi(status);
}

#endif
