#ifndef PALPATE_DEVICE_ROTATION_H
#define PALPATE_DEVICE_ROTATION_H

#include <cmath>

namespace palpate {

/** Writes the unit quaternion (x, y, z, w) of a rotation matrix m[row][column]. */
inline void quaternionOf(const double (&m)[3][3], double (&dest)[4]) {
  const double part[4] = {m[0][0] - m[1][1] - m[2][2], m[1][1] - m[0][0] - m[2][2],
                          m[2][2] - m[0][0] - m[1][1], m[0][0] + m[1][1] + m[2][2]};
  int largest = 3;  // divide by the largest component, which is never small
  for (int i = 0; i < 3; i++) {
    largest = part[i] > part[largest] ? i : largest;
  }
  const double root = std::sqrt(part[largest] + 1);
  const double off = 0.5 / root;
  const double sum[3] = {m[1][2] + m[2][1], m[0][2] + m[2][0], m[0][1] + m[1][0]};
  const double difference[3] = {m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]};
  for (int i = 0; i < 3; i++) {
    dest[i] = largest == 3 ? difference[i] * off : i == largest ? root / 2 : 0;
    if (largest != 3 && i != largest) {
      dest[i] = sum[3 - i - largest] * off;
    }
  }
  dest[3] = largest == 3 ? root / 2 : difference[largest] * off;
}

/**
 * The axes of the frame that Force Dimension and Haption use (x towards the person, y right, z up),
 * one for each axis of our device frame (x right, y up, z towards the person).
 */
constexpr int kFromTowardsRightUp[3] = {1, 2, 0};

/** Converts a vector from that frame to ours. */
template <typename Number>
void toOurFrame(const Number* theirs, double factor, double (&ours)[3]) {
  for (int axis = 0; axis < 3; axis++) {
    ours[axis] = static_cast<double>(theirs[kFromTowardsRightUp[axis]]) * factor;
  }
}

/** Converts a vector from our frame to that frame. */
template <typename Number>
void toTheirFrame(const double (&ours)[3], Number* theirs) {
  for (int axis = 0; axis < 3; axis++) {
    theirs[kFromTowardsRightUp[axis]] = static_cast<Number>(ours[axis]);
  }
}

}  // namespace palpate

#endif
