#ifndef PALPATE_HID_LINKED_DEVICE_H
#define PALPATE_HID_LINKED_DEVICE_H

#include "hid/hid_backend.h"

namespace palpate::hid {

/**
 * A HID device over a link. A read takes all waiting reports and keeps the newest. A wrench is one
 * report, and the last report of a session has zero force. Subclasses define the meaning of the
 * bytes. One thread.
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

  /** Unpacks the bytes of one read into `sample`. Returns whether they contain a new sample. */
  virtual bool take(const uint8_t* bytes, size_t length, Sample& sample) = 0;

  /** Completes `sample` after the last report of a frame. Returns whether it is a new sample. */
  virtual bool finish(bool fresh, Sample& sample) = 0;

  /**
   * Writes the report that makes the motors exert a wrench. Returns its length; 0 if the device has
   * no motors.
   */
  virtual size_t pack(const Wrench& wrench, bool ending, uint8_t (&report)[kMostReportBytes]) = 0;

  /** Ends the session because of a fault of the device. */
  void fail(const std::string& why);

 private:
  /** The largest number of reports that one frame reads. A device that sends more is faulty. */
  static constexpr int kMostReadsAFrame = 64;

  Link link_;
  bool faulty_ = false;
};

}  // namespace palpate::hid

#endif
