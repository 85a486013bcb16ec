/*
 * The pipeline once more, compiled with other REAL and LANES than what a test is linked with. Its
 * functions get other names.
 */
#ifndef TESTS_PIPELINE_AGAIN_H
#define TESTS_PIPELINE_AGAIN_H

#define batch_classify          again_batch_classify
#define buffer_reserve          again_buffer_reserve
#define camera_call             again_camera_call
#define pipeline_assemble_round again_pipeline_assemble_round
#define pipeline_beyond_sides   again_pipeline_beyond_sides
#define pipeline_clear          again_pipeline_clear
#define pipeline_box_batches    again_pipeline_box_batches
#define pipeline_cover_band     again_pipeline_cover_band
#define pipeline_create         again_pipeline_create
#define pipeline_draw           again_pipeline_draw
#define pipeline_draw_band      again_pipeline_draw_band
#define pipeline_finish         again_pipeline_finish
#define pipeline_free           again_pipeline_free
#define pipeline_is_hidden      again_pipeline_is_hidden
#define pipeline_is_outside     again_pipeline_is_outside
#define pipeline_leave_out      again_pipeline_leave_out
#define pipeline_next_round     again_pipeline_next_round
#define pipeline_order          again_pipeline_order
#define pipeline_reorder        again_pipeline_reorder
#define pipeline_place          again_pipeline_place
#define pipeline_run            again_pipeline_run
#define pipeline_sort_round     again_pipeline_sort_round
#define pipeline_stat_name      again_pipeline_stat_name
#define pipeline_use_threads    again_pipeline_use_threads
#define texture_wrapped_level   again_wrapped_level

#include "../../../common/pipeline.c"

#include "../../../common/pipeline/assemble.c"
#include "../../../common/pipeline/bands.c"
#include "../../../common/pipeline/batch.c"
#include "../../../common/pipeline/objects.c"
#include "../../../common/pipeline/rounds.c"

#endif
