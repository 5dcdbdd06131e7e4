#ifndef PALPATE_HID_BYTES_H
#define PALPATE_HID_BYTES_H

#include <cstdint>

namespace palpate::hid {

// Reads and writes little-endian numbers of a report on every processor.

inline uint16_t uint16At(const uint8_t* from) {
  return static_cast<uint16_t>(from[0] | from[1] << 8);
}

inline int16_t int16At(const uint8_t* from) { return static_cast<int16_t>(uint16At(from)); }

inline uint32_t uint32At(const uint8_t* from) {
  return uint16At(from) | static_cast<uint32_t>(uint16At(from + 2)) << 16;
}

inline void putUint16(uint8_t* to, uint16_t value) {
  to[0] = static_cast<uint8_t>(value);
  to[1] = static_cast<uint8_t>(value >> 8);
}

inline void putInt16(uint8_t* to, int16_t value) { putUint16(to, static_cast<uint16_t>(value)); }

inline void putUint32(uint8_t* to, uint32_t value) {
  putUint16(to, static_cast<uint16_t>(value));
  putUint16(to + 2, static_cast<uint16_t>(value >> 16));
}

}  // namespace palpate::hid

#endif
