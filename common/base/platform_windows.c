/* Windows: see platform.h. */
#define _POSIX_C_SOURCE 200809L
#include "base/platform.h"

#ifdef _WIN32

#include <limits.h>
#include <stdlib.h>
#include <wchar.h>
#include <windows.h>

#include <shellapi.h> /* only after windows.h */

/* The path of the build directory, which the compiler was called with, may be in the system's own
 * code page. */
struct windows_wide windows_widen(const char *path) {
    struct windows_wide wide;
    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide.path, WINDOWS_PATH) ==
            0 &&
        MultiByteToWideChar(CP_ACP, 0, path, -1, wide.path, WINDOWS_PATH) == 0) {
        wide.path[0] = L'\0';
    }
    return wide;
}

/* What a function of POSIX returns: 0, or -1 and the reason in errno. */
static int result(BOOL done) {
    DWORD reason = done ? ERROR_SUCCESS : GetLastError();
    if (!done) {
        errno = reason == ERROR_ACCESS_DENIED || reason == ERROR_SHARING_VIOLATION ? EACCES
                : reason == ERROR_DISK_FULL                                        ? ENOSPC
                                                                                   : ENOENT;
    }
    return done ? 0 : -1;
}

int windows_open(const char *path, int flags, ...) {
    return _wopen(windows_widen(path).path, flags, _S_IREAD | _S_IWRITE);
}

static unsigned most(size_t size) {
    return size < INT_MAX ? (unsigned)size : INT_MAX;
}

ssize_t windows_read(int file, void *data, size_t size) {
    return _read(file, data, most(size));
}

ssize_t windows_write(int file, const void *data, size_t size) {
    return _write(file, data, most(size));
}

/* The two numbers that tell files apart have the 48 bits that a file of NTFS has. */
int windows_stat(const char *path, struct stat *status) {
    BY_HANDLE_FILE_INFORMATION info;
    HANDLE file = CreateFileW(windows_widen(path).path, 0,
                              FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, NULL,
                              OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    bool found = file != INVALID_HANDLE_VALUE && GetFileInformationByHandle(file, &info);
    int done = result(found);
    if (found) {
        bool directory = (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
        *status = (struct stat){
            .st_mode = directory ? S_IFDIR : S_IFREG,
            .st_dev = info.nFileIndexLow ^ info.dwVolumeSerialNumber,
            .st_ino = (_ino_t)info.nFileIndexHigh,
            .st_size = info.nFileSizeHigh > 0 || info.nFileSizeLow > LONG_MAX
                           ? LONG_MAX
                           : (_off_t)info.nFileSizeLow,
        };
    }
    if (file != INVALID_HANDLE_VALUE) {
        CloseHandle(file);
    }
    return done;
}

/* Over an existing file, as POSIX does. */
int windows_rename(const char *from, const char *to) {
    return result(
        MoveFileExW(windows_widen(from).path, windows_widen(to).path, MOVEFILE_REPLACE_EXISTING));
}

int windows_unlink(const char *path) {
    return _wunlink(windows_widen(path).path);
}

int windows_mkdir(const char *path) {
    return _wmkdir(windows_widen(path).path);
}

/* In UTF-8, with / for \; NULL when memory runs out. */
static char *argument(const wchar_t *wide) {
    int size = WideCharToMultiByte(CP_UTF8, 0, wide, -1, NULL, 0, NULL, NULL);
    char *text = malloc((size_t)size + 1);
    for (int i = 0; text != NULL && i < size; i++) {
        if (i == 0) {
            WideCharToMultiByte(CP_UTF8, 0, wide, -1, text, size, NULL, NULL);
        }
        text[i] = text[i] == '\\' ? '/' : text[i];
    }
    return text;
}

/* The arguments stay allocated until the program ends. */
void windows_begin(int *argc, char ***argv) {
    int count;
    wchar_t **wide = CommandLineToArgvW(GetCommandLineW(), &count);
    char **arguments = wide == NULL ? NULL : calloc((size_t)count + 1, sizeof *arguments);
    _setmode(STDIN_FILENO, _O_BINARY);
    _setmode(STDOUT_FILENO, _O_BINARY);
    if (arguments == NULL) {
        return;
    }
    for (int i = 0; i < count; i++) {
        arguments[i] = argument(wide[i]);
    }
    *argc = count;
    *argv = arguments;
}

bool platform_is_absolute(const char *path) {
    return path[0] == '/' || path[0] == '\\' || (path[0] != '\0' && path[1] == ':');
}

size_t platform_processors(void) {
    SYSTEM_INFO info;
    GetSystemInfo(&info);
    return info.dwNumberOfProcessors;
}

void signals_hold(signal_set *before) {
    *before = 0;
    SetConsoleCtrlHandler(NULL, TRUE);
}

void signals_release(const signal_set *before) {
    (void)before;
    SetConsoleCtrlHandler(NULL, FALSE);
}

#endif
