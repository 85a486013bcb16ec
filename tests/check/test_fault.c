/* Tests of what the check makes of a sanitizer's words: where the fault is, and what it is. */
#include "fault.h"
#include "unit/unit.h"

/* The place is in the step's own file, though a header's function was called. */
static void test_place_of_fault(void) {
    static const struct {
        const char *messages, *said;
    } cases[] = {
        {"/a/step02_b/main.c:12:5: runtime error: index 9 out of bounds\n",
         "step02_b/main.c:12: index 9 out of bounds"},
        {"common/raster.h:138:26: runtime error: division by zero\n"
         "    #0 0x5581 in floor_divide common/raster.h:138\n"
         "    #1 0x5582 in line step02_b/main.c:126\n"
         "    #2 0x5583 in draw step02_b/scenes.h:67\n",
         "step02_b/main.c:126: division by zero"},
        {"x: step02_b/main.c:4: f: Assertion `n > 1' failed.\n"
         "==9==ERROR: AddressSanitizer: ABRT on unknown address 0x03 (pc 0x04 T0)\n"
         "    #0 0x05 in __GI_abort stdlib/abort.c:79\n"
         "    #1 0x06 in f step02_b/main.c:4\n",
         "step02_b/main.c:4: f() stops the program: Assertion `n > 1' failed."},
        {"==9==ERROR: AddressSanitizer: ABRT on unknown address 0x03 (pc 0x04 T0)\n"
         "    #0 0x05 in __GI_abort stdlib/abort.c:79\n"
         "    #1 0x06 in main step02_b/main.c:5:58\n",
         "step02_b/main.c:5: main() stops the program: abort()"},
        {"common/raster.h:138:26: runtime error: division by zero\n",
         "common/raster.h:138: division by zero"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct result_text text = {""};
        CHECK_ROW(fault_describe(&text, "step02_b", cases[i].messages), cases[i].said);
        CHECK_TEXT(text.text, cases[i].said);
    }
}

UNIT_MAIN(TEST(test_place_of_fault))
