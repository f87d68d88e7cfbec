/* Galileo's paradox: beads take one time along all chords from the top of a circle, but for friction.
 *
 *     cc -I.. descent_time.c ../galileo.c ... -lm      or the target descent_time of CMakeLists.txt
 *
 * Prints the descent time, in s, at 10 to 80 degrees; diameter 1 m, g 9.81 m/s^2, friction 0.1, drag 0.5/s.
 */
#include <stdio.h>

#include "galileo.h"

int main(void)
{
    const double degree = 0.017453292519943295, diameter = 1.0, g = 9.81, mu = 0.1, gamma = 0.5;
    puts("degrees         free     friction         drag         both");
    for (int angle = 10; angle <= 80; angle += 10) {
        const double theta = angle * degree;
        printf("%7d %12.9f %12.9f %12.9f %12.9f\n", angle, gs_chord_descent_time_free(theta, diameter, g),
               gs_chord_descent_time_friction(theta, diameter, g, mu),
               gs_chord_descent_time_drag(theta, diameter, g, gamma),
               gs_chord_descent_time_friction_drag(theta, diameter, g, mu, gamma));
    }
    return 0;
}
