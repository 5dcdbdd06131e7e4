#ifndef PALPATE_HID_LINKED_DEVICE_H
#define PALPATE_HID_LINKED_DEVICE_H

#include "hid/hid_backend.h"

namespace palpate::hid {

/**
 * A device over a link, as all of them are: reports are drained to the newest, a wrench is one
 * report, the last one says zero. What the bytes mean is the kind's. One thread.
 */
class LinkedDevice : public Device {
 public:
  LinkedDevice(Link link, std::shared_ptr<Trace> trace, Specification specification)
      : Device(std::move(trace), std::move(specification)), link_(std::move(link)) {}

  ReadStatus read(Sample& sample) final;
  bool write(const Wrench& wrench) final;
  bool close() final;

 protected:
  static constexpr size_t kMostReportBytes = 64;

  /** Takes the bytes of one read into `sample`; whether there was a new sample among them. */
  virtual bool take(const uint8_t* bytes, size_t length, Sample& sample) = 0;

  /** After the last report of a frame: completes `sample`; whether it is a new one. */
  virtual bool finish(bool fresh, Sample& sample) = 0;

  /** Writes the report that makes the motors do this; its length, or 0 where there are none. */
  virtual size_t pack(const Wrench& wrench, bool ending, uint8_t (&report)[kMostReportBytes]) = 0;

  /** Ends the session: the device itself cannot go on. */
  void fail(const std::string& why);

 private:
  /** So many reports at once are drained; a device that sends faster is faulty. */
  static constexpr int kMostReadsAFrame = 64;

  Link link_;
  bool faulty_ = false;
};

}  // namespace palpate::hid

#endif
