/*
 * Small changes of C source files, which some test should notice.
 *
 *     mutate list SEED FILE...    all changes, one a line
 *     mutate make FILE NUMBER     the file with one of them, on standard output
 *
 * A line has eight columns with tabs between them: key, number, line, operator, the function whose
 * arguments are swapped, file, the line before, the line after. Sorted by their keys the lines are
 * in a random order that the seed chooses. A key comes from seed, file and text, so that a change
 * keeps its place in the order while lines move and others change.
 *
 * Only the inside of functions is changed: no comment, string, preprocessor line or assertion, and
 * of a declaration only the values. Whether a change compiles, the compiler decides. The sources
 * are formatted by clang-format: `a * b` is a product, `type *name` isn't.
 */
#include <ctype.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SOURCE_LIMIT = 1 << 18 };

struct token {
    int begin, end, line; /* in the text, end exclusive */
    int next;             /* the token after this one; of an opening bracket, behind its pair */
    bool starts;          /* a statement */
    bool kept;            /* as it is */
};

static const char *path, *seed; /* no seed: one change is made */
static char text[SOURCE_LIMIT];
static struct token tokens[SOURCE_LIMIT];
static int token_count, changes, wanted;

/* ---- Tokens ---- */

/* Is the token one of these words, each with a blank before and behind it? */
static bool is(int i, const char *words) {
    char word[64];
    snprintf(word, sizeof word, " %.*s ", tokens[i].end - tokens[i].begin, text + tokens[i].begin);
    return strstr(words, word) != NULL;
}

static bool is_name(int i) {
    char first = text[tokens[i].begin];
    return isalpha((unsigned char)first) || first == '_';
}

/* What lies between tokens: white space, comments, preprocessor lines. */
static int skip(int at) {
    while (text[at] != '\0') {
        bool first = at == 0 || text[at - 1] == '\n';
        if (isspace((unsigned char)text[at])) {
            at++;
        } else if (strncmp(text + at, "/*", 2) == 0) {
            const char *closed = strstr(text + at, "*/");
            at = closed != NULL ? (int)(closed + 2 - text) : (int)strlen(text);
        } else if (first && text[at] == '#') {
            do {
                at += 1 + (int)strcspn(text + at + 1, "\n");
            } while (text[at - 1] == '\\');
        } else {
            break;
        }
    }
    return at;
}

static int token_end(int at) {
    static const char operators[] = "<>=!&|+-*/%^";
    bool number = isdigit((unsigned char)text[at]), hex = strncmp(text + at, "0x", 2) == 0;
    int end = at + 1;
    if (text[at] == '"' || text[at] == '\'') {
        while (text[end] != text[at] && text[end] != '\0') {
            end += text[end] == '\\' ? 2 : 1;
        }
        return end + 1;
    }
    if (strchr(operators, text[at]) != NULL) {
        return at + (int)strspn(text + at, operators);
    }
    while ((isalnum((unsigned char)text[at]) || text[at] == '_') &&
           (isalnum((unsigned char)text[end]) || text[end] == '_' || (number && text[end] == '.') ||
            (number && strchr("+-", text[end]) && strchr(hex ? "pP" : "eE", text[end - 1])))) {
        end++;
    }
    return end;
}

static void find_tokens(void) {
    static int open[SOURCE_LIMIT];
    int depth = 0, line = 1;
    token_count = 0;
    for (int at = 0, begin = skip(0); text[begin] != '\0'; begin = skip(at)) {
        for (; at < begin; at++) {
            line += text[at] == '\n';
        }
        at = token_end(begin);
        if (strchr(")]}", text[begin]) != NULL && depth > 0) {
            tokens[open[--depth]].next = token_count + 1;
        }
        if (strchr("([{", text[begin]) != NULL) {
            open[depth++] = token_count;
        }
        tokens[token_count] = (struct token){begin, at, line, token_count + 1, false, false};
        token_count++;
    }
    tokens[token_count] = (struct token){.next = token_count};
}

/* ---- A change ---- */

static uint64_t hash(uint64_t sum, const char *word) {
    for (; *word != '\0'; word++) {
        sum = (sum ^ (unsigned char)*word) * 0x100000001b3u;
    }
    sum = (sum ^ sum >> 31) * 0x9e3779b97f4a7c15u;
    return sum ^ sum >> 29;
}

static void list_change(int token, const char *name, const char *function, int end,
                        const char *replacement) {
    int begin = tokens[token].begin, from = begin;
    while (from > 0 && text[from - 1] != '\n') {
        from--;
    }
    from += (int)strspn(text + from, " ");
    char before[1000], after[1000];
    snprintf(before, sizeof before, "%.*s", (int)strcspn(text + from, "\n"), text + from);
    snprintf(after, sizeof after, "%.*s%s%.*s", begin - from, text + from, replacement,
             (int)strcspn(text + end, "\n"), text + end);
    after[strcspn(after, "\n")] = '\0';
    printf("%016" PRIx64 "\t%d\t%d\t%s\t%s\t%s\t%s\t%s\n",
           hash(hash(hash(hash(0, seed), path), before), after), changes, tokens[token].line, name,
           function, path, before, after);
}

/* Put something instead of a token and all others before `behind`, with as many lines. */
static void change(int token, int behind, const char *name, const char *function,
                   const char *format, ...) {
    static char replacement[SOURCE_LIMIT];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(replacement, sizeof replacement, format, arguments);
    va_end(arguments);
    int end = tokens[behind - 1].end;
    changes++;
    if (seed != NULL) {
        list_change(token, name, function, end, replacement);
    } else if (changes == wanted) {
        printf("%.*s%s%s", tokens[token].begin, text, replacement, text + end);
    }
}

/* ---- Expressions ---- */

static void change_operator(int i) {
    static const char *const pairs[][3] = {
        {"comparison", " < ", "<="},  {"comparison", " <= ", "<"},  {"comparison", " > ", ">="},
        {"comparison", " >= ", ">"},  {"comparison", " == ", "!="}, {"comparison", " != ", "=="},
        {"arithmetic", " + ", "-"},   {"arithmetic", " - ", "+"},   {"arithmetic", " * ", "/"},
        {"arithmetic", " / ", "*"},   {"arithmetic", " % ", "/"},   {"arithmetic", " += ", "-="},
        {"arithmetic", " -= ", "+="}, {"arithmetic", " *= ", "/="}, {"arithmetic", " /= ", "*="},
        {"arithmetic", " & ", "|"},   {"arithmetic", " | ", "&"},   {"arithmetic", " ^ ", "|"},
        {"arithmetic", " &= ", "|="}, {"arithmetic", " |= ", "&="}, {"arithmetic", " << ", ">>"},
        {"arithmetic", " >> ", "<<"}, {"branch", " && ", "||"},     {"branch", " || ", "&&"},
        {"branch", " ? ", "|| 1 ?"},  {"branch", " ? ", "&& 0 ?"}};
    bool spaced = isspace((unsigned char)text[tokens[i].end]);
    for (size_t k = 0; k < sizeof pairs / sizeof pairs[0]; k++) {
        if (spaced && is(i, pairs[k][1])) {
            change(i, i + 1, pairs[k][0], "-", "%s", pairs[k][2]);
        }
    }
    if (is(i, " ++ -- ")) {
        change(i, i + 1, "arithmetic", "-", is(i, " ++ ") ? "--" : "++");
    } else if (is(i, " - ! ") && !spaced && !is(i - 1, " ( ")) {
        change(i, i + 1, is(i, " ! ") ? "branch" : "arithmetic", "-", "");
    }
}

/* Whole numbers are one more and one less, others one more, and 1e-9 becomes 1e-4. */
static void change_number(int i) {
    char number[64], *suffix;
    snprintf(number, sizeof number, "%.*s", tokens[i].end - tokens[i].begin,
             text + tokens[i].begin);
    unsigned long long value = strtoull(number, &suffix, 0);
    if (strspn(suffix, "uUlL") == strlen(suffix)) {
        change(i, i + 1, "constant", "-", "%llu%s", value + 1, suffix);
        if (value > 0) {
            change(i, i + 1, "constant", "-", "%llu%s", value - 1, suffix);
        }
        return;
    }
    change(i, i + 1, "constant", "-", "(%s + 1)", number);
    char *exponent = strpbrk(number, number[1] == 'x' ? "pP" : "eE");
    if (exponent != NULL) {
        long halved = strtol(exponent + 1, &suffix, 10) / 2;
        change(i, i + 1, "constant", "-", "%.*s%ld%s", (int)(exponent + 1 - number), number, halved,
               suffix);
    }
}

/* The comma or bracket behind the argument that begins at i. */
static int argument_end(int i) {
    while (!is(i, " , ) ")) {
        i = tokens[i].next;
    }
    return i;
}

/* Exchange each argument of a call with the next one. */
static void swap_arguments(int i) {
    char name[64];
    snprintf(name, sizeof name, "%.*s", tokens[i].end - tokens[i].begin, text + tokens[i].begin);
    int a = i + 2, comma = argument_end(a);
    while (is(comma, " , ")) {
        int b = comma + 1, close = argument_end(b);
        const char *first = text + tokens[a].begin, *second = text + tokens[b].begin;
        int first_size = tokens[comma - 1].end - tokens[a].begin;
        int second_size = tokens[close - 1].end - tokens[b].begin;
        change(a, close, "swapped", name, "%.*s%.*s%.*s", second_size, second,
               (int)(second - first) - first_size, first + first_size, first_size, first);
        a = b;
        comma = close;
    }
}

/* ---- Statements ---- */

static void change_branch(int i) {
    int first = i + 2, behind = tokens[i + 1].next - 1;
    const char *condition = text + tokens[first].begin;
    int size = tokens[behind - 1].end - tokens[first].begin;
    change(first, behind, "branch", "-", "!(%.*s)", size, condition);
    change(first, behind, "branch", "-", "0 && (%.*s)", size, condition);
    if (is(i, " if ")) {
        change(first, behind, "branch", "-", "1 || (%.*s)", size, condition);
    }
}

static bool is_declaration(int i) {
    bool pointer = is(i + 1, " * ** ") && text[tokens[i + 1].end] != ' ';
    return is(i, " struct union enum const static ") ||
           (is_name(i) && !is(i, " return goto ") && (is_name(i + 1) || pointer));
}

/* Of an assertion or a declaration only the values behind = may change. */
static void keep(int i, int end) {
    bool value = false;
    for (int next; i < end; i = next) {
        next = tokens[i].next;
        value = is(i, " = ") || (value && !is(i, " , "));
        for (int k = i; k < next && !value; k++) {
            tokens[k].kept = true;
        }
    }
}

static void delete_statement(int i, int end) {
    char lines[100] = "";
    for (int line = tokens[i].line; line < tokens[end].line; line++) {
        strncat(lines, "\n", sizeof lines - 1 - strlen(lines));
    }
    change(i, end, "deleted", "-", "%s", lines);
}

/* Change the statement as a whole, and mark where the next one begins. */
static void change_statement(int i) {
    int next = i + 1;
    if (is(i, " if while for switch ")) {
        next = tokens[next].next;
        if (is(i, " if while ")) {
            change_branch(i);
        }
    } else if (is(i, " case default ")) {
        while (!is(next - 1, " : ")) {
            next++;
        }
    } else if (is(i, " { ")) {
        tokens[tokens[i].next].starts = true;
    } else if (!is(i, " else do ; } ")) {
        while (!is(next, " ; ") && next < token_count) {
            next = tokens[next].next;
        }
        if (is_declaration(i) || is(i, " assert ")) {
            keep(i, next);
        } else if (!is(i, " return goto ")) {
            delete_statement(i, next);
        }
        next++;
    }
    tokens[next].starts = true;
}

static void change_function(int open) {
    tokens[open + 1].starts = true;
    for (int i = open + 1; i < tokens[open].next - 1; i++) {
        if (tokens[i].starts) {
            change_statement(i);
        }
        if (tokens[i].kept) {
            continue;
        }
        if (isdigit((unsigned char)text[tokens[i].begin])) {
            change_number(i);
        } else if (is_name(i) && is(i + 1, " ( ") && !is(i, " if while for switch ")) {
            swap_arguments(i);
        } else {
            change_operator(i);
        }
    }
}

static bool change_file(const char *file) {
    FILE *stream = fopen(file, "r");
    size_t size = stream != NULL ? fread(text, 1, sizeof text - 1, stream) : 0;
    bool whole = stream != NULL && feof(stream);
    if (stream != NULL) {
        fclose(stream);
    }
    text[size] = '\0';
    path = file;
    changes = 0;
    find_tokens();
    for (int i = 1; i < token_count; i = tokens[i].next) {
        if (is(i, " { ") && is(i - 1, " ) ")) {
            change_function(i);
        }
    }
    return whole || !fprintf(stderr, "mutate: %s: missing or too large\n", file);
}

int main(int argc, char **argv) {
    bool done = true;
    if (argc > 3 && strcmp(argv[1], "list") == 0) {
        seed = argv[2];
        for (int i = 3; i < argc; i++) {
            done = change_file(argv[i]) && done;
        }
    } else if (argc == 4 && strcmp(argv[1], "make") == 0) {
        wanted = atoi(argv[3]);
        done = change_file(argv[2]) && wanted >= 1 && wanted <= changes;
    } else {
        fputs("Usage: mutate list SEED FILE... | mutate make FILE NUMBER\n", stderr);
        return 2;
    }
    return done ? 0 : 1;
}
