/* A circle of one's own, checked by gradus: Bresenham's, with all eight octants of each step.
 *
 *   cc -std=c99 -o circle circle.c
 *   gradus cases bresenham_circle --json > cases.json
 *   ./circle < cases.json > results.json
 *   gradus check bresenham_circle results.json
 *
 * It looks for the few texts that it needs in cases.json rather than to read JSON. Rows are counted downwards
 * here, as in the memory of a picture: "conventions" say so, and of how many rows the picture is.
 * Compiled with -DMISTAKE it forgets to make p smaller where y does, and gradus says from which step on.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 4096 };

static int pixels;

static void plot(long x, long y) { printf("%s[%ld, %ld]", pixels++ ? ", " : "", x, ROWS - 1 - y); }

/* The mirror images of a place, each once. */
static void plot_mirrored(long cx, long cy, long x, long y) {
  long places[8][2] = {{x, y}, {y, x}, {y, -x}, {x, -y}, {-x, -y}, {-y, -x}, {-y, x}, {-x, y}};
  for (int i = 0; i < 8; ++i) {
    int known = 0;
    for (int j = 0; j < i; ++j)
      known = known || (places[i][0] == places[j][0] && places[i][1] == places[j][1]);
    if (!known) plot(cx + places[i][0], cy + places[i][1]);
  }
}

static void circle(long cx, long cy, long radius) {
  long x = 0, y = radius, p = 3 - 2 * radius;
  while (x <= y) {
    plot_mirrored(cx, cy, x, y);
    if (p < 0) {
      p += 4 * x + 6;
    } else {
#ifdef MISTAKE
      p += 4 * x + 10;
#else
      p += 4 * (x - y) + 10;
#endif
      --y;
    }
    ++x;
  }
}

int main(void) {
  static char text[1 << 20];
  text[fread(text, 1, sizeof text - 1, stdin)] = '\0';
  printf("{\"topic\": \"bresenham_circle\", \"conventions\": {\"y\": \"down\", \"height\": %d},\n\"answers\": [", ROWS);
  int answers = 0;
  for (char* at = text; (at = strstr(at, "\"case\": \"")) != NULL;) {
    char name[32];
    long cx, cy, radius;
    const char *center = strstr(at, "\"center\": "), *size = strstr(at, "\"radius\": ");
    int read = sscanf(at, "\"case\": \"%31[^\"]\"", name) == 1 && center && size &&
               sscanf(center, "\"center\": [%ld, %ld]", &cx, &cy) == 2 &&
               sscanf(size, "\"radius\": %ld", &radius) == 1;
    if (!read) {
      fprintf(stderr, "circle: a case with a center and a radius expected\n");
      return EXIT_FAILURE;
    }
    printf("%s\n{\"case\": \"%s\", \"result\": {\"pixels\": [", answers++ ? "," : "", name);
    pixels = 0;
    circle(cx, cy, radius);
    printf("]}}");
    at += strlen("\"case\": \"");
  }
  printf("\n]}\n");
  return EXIT_SUCCESS;
}
