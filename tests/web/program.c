/* A program in C99 that drops a stone, as somebody would who has read goishi.h and nothing else. */

#include <goishi.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int status, const char* what) {
  if (status != GOISHI_OK) {
    fprintf(stderr, "%s: %s\n", what, goishi_message());
    exit(1);
  }
}

int main(void) {
  double stone[GOISHI_STONE_SIZE], measures[GOISHI_MEASURES_SIZE], state[GOISHI_STATE_SIZE];
  double board[GOISHI_BOARD_SIZE], settings[GOISHI_SETTINGS_SIZE], info[GOISHI_DROP_SIZE], hold[GOISHI_HOLD_SIZE];
  double event[GOISHI_EVENT_SIZE], motion[GOISHI_MOTION_SIZE], time;
  const double pose[GOISHI_POSE_SIZE] = {0.0, 0.0, 0.03, 0.9, 0.3, 0.0, 0.0}; /* turned to one side */
  const double still[3] = {0.0, 0.0, 0.0}, spin[3] = {0.0, 0.0, 5.0};
  double scene_settings[GOISHI_SCENE_SETTINGS_SIZE], scene_info[GOISHI_SCENE_SIZE], stones[2 * GOISHI_SCENE_STONE_SIZE];
  size_t id = 0;
  goishi_drop* drop = NULL;
  goishi_scene* scene = NULL;

  check(goishi_catalogue_stone(33, GOISHI_WHITE, 0.001, stone, GOISHI_STONE_SIZE), "the stone");
  check(goishi_measures(stone, GOISHI_STONE_SIZE, measures, GOISHI_MEASURES_SIZE), "its measures");
  check(goishi_state(stone, GOISHI_STONE_SIZE, pose, GOISHI_POSE_SIZE, still, 3, spin, 3, state, GOISHI_STATE_SIZE),
        "the start");
  check(goishi_board(board, GOISHI_BOARD_SIZE), "the board");
  check(goishi_settings(settings, GOISHI_SETTINGS_SIZE), "the settings");
  settings[GOISHI_TOLERANCE] = 1e-6;
  check(goishi_drop_create(stone, GOISHI_STONE_SIZE, state, GOISHI_STATE_SIZE, board, GOISHI_BOARD_SIZE, settings,
                           GOISHI_SETTINGS_SIZE, 10000, &drop),
        "the drop");
  check(goishi_drop_advance(drop, INFINITY), "going on");
  check(goishi_drop_info(drop, info, GOISHI_DROP_SIZE), "its end");
  check(goishi_drop_events(drop, (size_t)info[GOISHI_DROP_EVENTS] - 1, event, GOISHI_EVENT_SIZE), "its last event");
  time = info[GOISHI_DROP_TIME] / 2.0;
  check(goishi_drop_motions(drop, &time, 1, GOISHI_AFTER, motion, GOISHI_MOTION_SIZE), "its middle");
  check(goishi_holds(stone, GOISHI_STONE_SIZE, info + GOISHI_DROP_MOTION, GOISHI_POSE_SIZE, board, GOISHI_BOARD_SIZE,
                     settings, GOISHI_SETTINGS_SIZE, hold, GOISHI_HOLD_SIZE),
        "whether it stays");
  goishi_drop_free(drop);

  check(goishi_scene_settings(scene_settings, GOISHI_SCENE_SETTINGS_SIZE), "the settings of a scene");
  check(goishi_scene_create(board, GOISHI_BOARD_SIZE, scene_settings, GOISHI_SCENE_SETTINGS_SIZE, &scene), "the scene");
  check(goishi_scene_add(scene, stone, GOISHI_STONE_SIZE, state, GOISHI_STATE_SIZE, &id), "a stone in it");
  state[GOISHI_POSITION + 2] += 0.03; /* the other falls on it */
  check(goishi_scene_add(scene, stone, GOISHI_STONE_SIZE, state, GOISHI_STATE_SIZE, &id), "another one");
  check(goishi_scene_run_until_rest(scene, 20.0), "the scene's end");
  check(goishi_scene_info(scene, scene_info, GOISHI_SCENE_SIZE), "what it is");
  check(goishi_scene_stones(scene, 0, stones, 2 * GOISHI_SCENE_STONE_SIZE), "where its stones are");
  goishi_scene_free(scene);

  printf("goishi %s: %.5f kg, at rest after %.4f s at z = %.6f m\n", goishi_version(), measures[GOISHI_TRUE_MASS],
         info[GOISHI_DROP_TIME], info[GOISHI_DROP_MOTION + 2]);
  if (info[GOISHI_DROP_STATUS] != GOISHI_REST || event[GOISHI_EVENT_KIND] != GOISHI_KIND_REST ||
      hold[GOISHI_HOLDS] != 1.0 || !(fabs(info[GOISHI_DROP_MOTION + 2] - stone[GOISHI_HEIGHT] / 2.0) < 1e-5) ||
      !(motion[GOISHI_ENERGY] > info[GOISHI_DROP_MOTION + GOISHI_ENERGY])) {
    fprintf(stderr, "it does not lie on its face, at rest\n");
    return 1;
  }
  if (scene_info[GOISHI_SCENE_MOVING] != 0.0 || scene_info[GOISHI_SCENE_PAIR_IMPACTS] < 1.0 || id != 1 ||
      stones[GOISHI_SCENE_STONE_SIZE + GOISHI_SCENE_STONE_MODE] != GOISHI_MODE_REST) {
    fprintf(stderr, "two stones do not meet and come to rest\n");
    return 1;
  }
  if (goishi_measures(stone, 5, measures, GOISHI_MEASURES_SIZE) != GOISHI_INVALID_ARGUMENT ||
      goishi_message()[0] == '\0') {
    fprintf(stderr, "a wrong size is not refused\n");
    return 1;
  }
  return 0;
}
