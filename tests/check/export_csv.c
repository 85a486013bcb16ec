/* A check's result as a table for programs that add up classes: see export.h. */
#include "export.h"

bool export_csv(struct bytes *report, const struct check_result *result, const char *references,
                struct error *error) {
    bool done = bytes_print(report, "step,task,state,points,most\n");
    (void)references;
    for (size_t i = 0; i < result->step_count; i++) {
        const struct step_result *step = &result->steps[i];
        for (size_t k = 0; k < step->task_count && done; k++) {
            const struct task_result *task = &step->tasks[k];
            done = bytes_print(report, "%s,%s,%s,%u,%u\n", step->name, task->name.text,
                               result_state_name(task->state), task->points, task->most);
        }
    }
    return done || error_out_of_memory(error);
}
