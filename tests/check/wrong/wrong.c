/*
 * The small programs that fail, each in its own way, as one source: which of them it is, its name
 * says. What a compiler or a sanitizer finds fault with has its own file next to this one.
 */
#define _POSIX_C_SOURCE 200809L

#include <assert.h>
#include <dirent.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* ---- A picture, drawn and saved without any of the course's code ---- */

/* A large disc, lit from the left, covers most of a smaller one that lies behind it and is drawn
 * last, so that a depth test is what makes the picture right. */
enum { PICTURE_SIZE = 200 };

struct picture {
    unsigned char bgr[PICTURE_SIZE][PICTURE_SIZE][3]; /* [0] is the bottom row */
    int depth[PICTURE_SIZE][PICTURE_SIZE];
};

/* A disc of the centre (x,y); `rule` moves every edge by so many pixels. */
static void picture_disc(struct picture *p, int x, int y, int radius, int depth, int rule,
                         int use_depth) {
    for (int j = 0; j < PICTURE_SIZE; j++) {
        for (int i = 0; i < PICTURE_SIZE; i++) {
            int dx = i - x - rule, dy = j - y;
            int inside = dx * dx + dy * dy < radius * radius;
            if (inside && (!use_depth || depth > p->depth[j][i])) {
                p->depth[j][i] = depth;
                p->bgr[j][i][0] = (unsigned char)(depth * 60);
                p->bgr[j][i][1] = (unsigned char)(100 - dx);
                p->bgr[j][i][2] = (unsigned char)(200 - depth * 40);
            }
        }
    }
}

static void picture_draw(struct picture *p, int rule, int use_depth) {
    memset(p, 0, sizeof *p);
    picture_disc(p, 100, 100, 80, 2, rule, use_depth);
    picture_disc(p, 60, 60, 30, 1, rule, use_depth);
}

/* The 18 bytes in front of a TGA of 24-bit pixels. */
static void picture_header(unsigned char header[18], int width, int height) {
    memset(header, 0, 18);
    header[2] = 2;
    header[12] = (unsigned char)(width & 255);
    header[13] = (unsigned char)(width >> 8);
    header[14] = (unsigned char)(height & 255);
    header[15] = (unsigned char)(height >> 8);
    header[16] = 24;
}

/* Make every value that is drawn lighter by so many levels. */
static void picture_add(struct picture *p, int levels) {
    unsigned char *values = p->bgr[0][0];
    for (size_t i = 0; i < sizeof p->bgr; i++) {
        values[i] = (unsigned char)(values[i] > 0 ? values[i] + levels : 0);
    }
}

/* Save the lower `height` rows as DIRECTORY/SCENE.tga. */
static void picture_save(const struct picture *p, int height, const char *directory,
                         const char *scene) {
    char path[1000];
    unsigned char header[18];
    snprintf(path, sizeof path, "%s/%s.tga", directory, scene);
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        perror(path);
        exit(9);
    }
    picture_header(header, PICTURE_SIZE, height);
    fwrite(header, 1, sizeof header, file);
    fwrite(p->bgr, sizeof p->bgr[0], (size_t)height, file);
    fclose(file);
}

/* Add a line to the file that the environment names WITNESS, where a test reads it. */
static void witness(const char *format, long number) {
    const char *path = getenv("WITNESS");
    FILE *file = path == NULL ? NULL : fopen(path, "a");
    if (file != NULL) {
        fprintf(file, format, number);
        fclose(file);
    }
}

/* ---- The programs ---- */

/* The program's arguments: `-o DIRECTORY`, perhaps --stats, `--only all` or `--only SCENE`, or what
 * is new. */
struct task {
    const char *directory;
    const char *only; /* NULL: all */
    bool stats, is_more;
};

/* The right picture of that scene, unless another one is wanted. */
static void right(const struct task *task, const char *scene) {
    static struct picture p;
    picture_draw(&p, 0, 1);
    if (task->only == NULL || strcmp(task->only, scene) == 0) {
        picture_save(&p, PICTURE_SIZE, task->directory, scene);
    }
}

/* One picture is too low, the other claims to be huge. */
static int size(const struct task *task) {
    static struct picture p;
    char path[1000];
    unsigned char header[18];
    picture_draw(&p, 0, 1);
    picture_save(&p, 150, task->directory, "depth");
    picture_header(header, 65535, 65535);
    snprintf(path, sizeof path, "%s/huge.tga", task->directory);
    FILE *file = fopen(path, "wb");
    fwrite(header, 1, sizeof header, file);
    return fclose(file);
}

/* What should be pictures are a text, a picture cut short, a link, a pipe, a directory. */
static int unreadable(const struct task *task) {
    unsigned char header[18];
    if (chdir(task->directory) != 0) {
        return 9;
    }
    FILE *file = fopen("text.tga", "w");
    fprintf(file, "This is no picture, however long it may be.\n");
    fclose(file);
    picture_header(header, PICTURE_SIZE, PICTURE_SIZE);
    file = fopen("short.tga", "wb");
    fwrite(header, 1, sizeof header, file);
    fclose(file);
    return symlink("/dev/zero", "link.tga") + mkfifo("pipe.tga", 0666) + mkdir("directory.tga", 0);
}

/* The picture is right, but the program says that it failed. */
static int status(const struct task *task) {
    right(task, "depth");
    fprintf(stderr, "\n-----\nstep09_status: bust.obj:17: face names\tvertex 99 of 12\nmore\n");
    return 1;
}

/* A null pointer is written to after the first scene. */
static int crash(const struct task *task) {
    right(task, "depth");
    volatile char *volatile nowhere = NULL;
    *nowhere = 1;
    return 0;
}

static int abort_itself(const struct task *task) {
    assert(task->directory[0] == 0);
    return 0;
}

static volatile sig_atomic_t asked;

static void end(int number) {
    asked = number;
}

/* The second scene takes for ever; asked to end, the program does so in its own way. */
static int sleep_long(const struct task *task) {
    signal(SIGTERM, end);
    right(task, "depth");
    witness("%ld\n", (long)getpid());
    while (!asked) {
        sleep(1); /* a signal cuts it short */
    }
    witness("ended by %ld\n", asked);
    return 0;
}

/* It stops itself, SIGTERM is ignored, and a child's child writes the picture when the time is
 * over. */
static int stubborn(const struct task *task) {
    signal(SIGTERM, SIG_IGN);
    if (fork() == 0) {
        if (fork() == 0) {
            witness("%ld\n", (long)getpid());
            sleep(3);
            witness("alive %ld\n", (long)getpid());
            right(task, "depth");
        }
        pause();
    }
    witness("%ld\n", (long)getpid());
    raise(SIGSTOP);
    return 0;
}

/* It ends whoever has started it, with the signal that the environment names. */
static int killer(const struct task *task) {
    (void)task;
    kill(getppid(), atoi(getenv("KILLS_WITH")));
    sleep(1);
    return 0;
}

/* Too many processes; only 100, and they end by themselves. */
static int crowd(const struct task *task) {
    (void)task;
    for (int i = 0; i < 100; i++) {
        pid_t child = fork();
        if (child == 0) {
            sleep(8);
            _exit(0);
        }
        if (child > 0) { /* told by who made it: it may be ended before it says a word */
            witness("%ld\n", (long)child);
        }
    }
    sleep(8);
    return 0;
}

/* The picture's file grows without end; 200 MB, should nobody stop it. */
static int large(const struct task *task) {
    static char block[1000000];
    char path[1000];
    snprintf(path, sizeof path, "%s/depth.tga", task->directory);
    FILE *file = fopen(path, "wb");
    for (int i = 0; i < 200; i++) {
        fwrite(block, 1, sizeof block, file);
    }
    fclose(file);
    witness("alive %ld\n", 0);
    return 0;
}

/* It says what it finds around itself, and fails, so that the check shows it. */
static int limits(const struct task *task) {
    struct rlimit cpu, size, core;
    char here[1000];
    int files = 0, open_files = 0;
    DIR *around = opendir(".");
    while (readdir(around) != NULL) {
        files++;
    }
    closedir(around);
    for (int i = 3; i < 256; i++) {
        open_files += dup2(i, 255) == 255;
    }
    getrlimit(RLIMIT_CPU, &cpu);
    getrlimit(RLIMIT_FSIZE, &size);
    getrlimit(RLIMIT_CORE, &core);
    fprintf(stderr, "here %d files %d open %d session %d cpu %d size %ld core %ld input %d\n",
            strcmp(getcwd(here, sizeof here), task->directory) == 0, files - 2, open_files,
            getsid(0) == getppid(), cpu.rlim_cur < 10000, (long)size.rlim_cur, (long)core.rlim_cur,
            getchar());
    return 3;
}

/* The picture is right; 2 MB of messages come with it, and a closed error output. */
static int noisy(const struct task *task) {
    for (int i = 0; i < 20000; i++) {
        fprintf(stderr, "%0100d\n", i);
        printf("%0100d\n", i);
    }
    fclose(stderr);
    close(2);
    right(task, "depth");
    return 0;
}

/* The picture is right, but one scene has no reference. */
static int no_reference(const struct task *task) {
    right(task, "depth");
    right(task, "nowhere");
    return 0;
}

/* The signal of a program that has used up its processor time. */
static int cpu_time(const struct task *task) {
    (void)task;
    return raise(SIGXCPU);
}

/* Right, after most of the second that the test allows. */
static int busy(const struct task *task) {
    while (clock() < CLOCKS_PER_SEC * 7 / 10) {
    }
    right(task, "depth");
    return 0;
}

/* A message that would paint over the score: control characters of one byte and of two, and marks
 * that turn the direction of writing. */
static int control(const struct task *task) {
    (void)task;
    fputs("\x1b[1A\xc2\x9b"
          "1A\xe2\x80\xae"
          "drow\x9bs\xc3\xa9\n",
          stderr);
    return 1;
}

/* The first scene ends the program; the second is right where it is drawn alone. */
static int first(const struct task *task) {
    if (task->only == NULL || strcmp(task->only, "depth") == 0) {
        abort();
    }
    right(task, "depth2");
    return 0;
}

/* Directories in directories, more than anybody needs. */
static int files(const struct task *task) {
    if (chdir(task->directory) != 0) {
        return 2;
    }
    for (int i = 0; i < 80; i++) {
        if (mkdir("deeper", 0777) != 0 || chdir("deeper") != 0) {
            return 2;
        }
    }
    sleep(8);
    return 0;
}

/* It draws one picture, and then ends as a division by 0 does. */
static int divided(const struct task *task) {
    right(task, "depth");
    return raise(SIGFPE);
}

/* It draws its own scene, and nothing that is new. */
static int old(const struct task *task) {
    if (!task->is_more) {
        right(task, "depth");
    }
    return 0;
}

/* All but the last scene take for ever, as the program does when it draws all of them. */
static int endless(const struct task *task) {
    while (task->only == NULL || strcmp(task->only, "depth5") != 0) {
        sleep(1);
    }
    right(task, "depth5");
    return 0;
}

/* Of a scene that is new the program dies. */
static int new_scene(const struct task *task) {
    if (task->is_more) {
        abort();
    }
    right(task, "depth");
    return 0;
}

static const struct {
    const char *name;
    int (*run)(const struct task *task);
} programs[] = {
    {"step06_size", size},
    {"step08_unreadable", unreadable},
    {"step09_status", status},
    {"step13_crash", crash},
    {"step14_abort", abort_itself},
    {"step15_sleep", sleep_long},
    {"step16_stubborn", stubborn},
    {"step17_killer", killer},
    {"step18_crowd", crowd},
    {"step19_large", large},
    {"step20_limits", limits},
    {"step22_noisy", noisy},
    {"step23_noreference", no_reference},
    {"step25_cputime", cpu_time},
    {"step26_control", control},
    {"step27_busy", busy},
    {"step33_first", first},
    {"step38_files", files},
    {"step43_divided", divided},
    {"step44_old", old},
    {"step48_endless", endless},
    {"step50_new", new_scene},
};

/* Those that only draw: a letter for each of their pictures depth, depth2, depth3 ...: r right, s
 * with another fill rule (every edge is one pixel further to the right), d without depth test,
 * b black; + three levels too light, - three too dark, 1 one too dark. And what they print with
 * --stats. */
static const struct {
    const char *name, *pictures, *stats;
} drawings[] = {
    {"step01_exact", "rr", ""},
    {"step02_shifted", "s", ""},
    {"step03_nodepth", "d", ""},
    {"step04_strict", "s", ""},
    {"step05_blank", "b", ""},
    {"step07_missing", "r", ""},
    {"step24_blankreference", "b", ""},
    {"step31_apart", "s", ""},
    {"step32_coverage", "s", ""},
    {"step34_todo", "rddd", ""},
    {"step35_work", "rrd",
     "depth.pixels: 9\ndepth2.pixels: 5\ndepth2.pixels: 2001\ndepth.pixels_more: 11\n"
     "depth2.hidden: 18446744073709550616\n"},
    {"step37_shared", "drrdd", ""},
    {"step40_near", "11", ""},
    {"step41_counted", "rr", "depth.pixels: 5\ndepth.rows: 7\ndepth2.pixels: 5\ndepth2.rows: 8\n"},
    {"step42_black", "rbb", "depth.pixels: 5\ndepth2.pixels: 5\ndepth3.pixels: 0\n"},
    {"step45_lighter", "+-", ""},
};

static int draw(const struct task *task, const char *kinds) {
    static struct picture p;
    if (task->only != NULL) {
        witness("one scene of %ld\n", (long)strlen(kinds));
    }
    for (int i = 0; kinds[i] != '\0'; i++) {
        char scene[] = "depth\0";
        const char kind = kinds[i];
        scene[5] = (char)(i > 0 ? '1' + i : '\0');
        picture_draw(&p, kind == 's', kind != 'd');
        picture_add(&p, kind == '+' ? 3 : kind == '-' ? -3 : kind == '1' ? -1 : 0);
        if (kind == 'b') {
            memset(&p, 0, sizeof p);
        }
        if (task->only == NULL || strcmp(task->only, scene) == 0) {
            picture_save(&p, PICTURE_SIZE, task->directory, scene);
        }
    }
    return 0;
}

int main(int argc, char **argv) {
    const char *name = strrchr(argv[0], '/');
    struct task task = {.only = NULL};
    for (int i = 1; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : NULL;
        task.directory = strcmp(argv[i], "-o") == 0 ? value : task.directory;
        task.only = strcmp(argv[i], "--only") == 0 && strcmp(value, "all") != 0 ? value : task.only;
        task.stats |= strcmp(argv[i], "--stats") == 0;
    }
    task.is_more = task.only != NULL || argc > 5;
    if (name == NULL || task.directory == NULL) {
        return 2;
    }
    for (size_t i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        if (strcmp(programs[i].name, name + 1) == 0) {
            return programs[i].run(&task);
        }
    }
    for (size_t i = 0; i < sizeof drawings / sizeof drawings[0]; i++) {
        if (strcmp(drawings[i].name, name + 1) == 0) {
            printf("%s", task.stats ? drawings[i].stats : "");
            return draw(&task, drawings[i].pictures);
        }
    }
    return 2;
}
