#include <jni.h>

#include <string>

#include "device/clock.h"
#include "device/session.h"

// This file only converts between Java and C++; device/session.cpp does the work.

namespace {

using palpate::Backend;
using palpate::Finding;
using palpate::Session;

std::string text(JNIEnv* env, jstring from) {
  const char* bytes = from != nullptr ? env->GetStringUTFChars(from, nullptr) : nullptr;
  if (bytes == nullptr) {
    return std::string();
  }
  std::string copy(bytes);
  env->ReleaseStringUTFChars(from, bytes);
  return copy;
}

jstring text(JNIEnv* env, const std::string& from) { return env->NewStringUTF(from.c_str()); }

void line(std::string& to, const char* key, const std::string& value) {
  to.append(key).append("\t");
  for (const char c : value) {
    const bool plain = c >= ' ' && c <= '~';  // vendors' texts are not always UTF-8
    to.push_back(plain ? c : '?');
  }
  to.append("\n");
}

std::string lines(const Finding& finding) {
  std::string all;
  line(all, "usable", finding.usable ? "1" : "0");
  line(all, "library", finding.library);
  line(all, "version", finding.version);
  line(all, "why", finding.why);
  for (const palpate::FoundDevice& device : finding.devices) {
    line(all, "device", device.id);
    line(all, "device.name", device.name);
    line(all, "device.usable", device.usable ? "1" : "0");
    line(all, "device.why", device.why);
  }
  return all;
}

int64_t nanos(jint millis) { return static_cast<int64_t>(millis) * palpate::kNanosPerMilli; }

}  // namespace

extern "C" {

/** Returns the handle, or 0 with the reason in why[0]. */
JNIEXPORT jlong JNICALL Java_org_palpate_device_jni_NativeCalls_open(JNIEnv* env, jclass,
                                                                     jstring backend, jstring id,
                                                                     jint waitMillis,
                                                                     jobjectArray why) {
  std::string reason;
  Backend* named = palpate::backendNamed(text(env, backend));
  if (named == nullptr) {
    reason = "no such back end";
  }
  const jlong handle =
      named != nullptr ? Session::open(*named, text(env, id), nanos(waitMillis), reason) : 0;
  if (handle == 0) {
    env->SetObjectArrayElement(why, 0, text(env, reason));
  }
  return handle;
}

JNIEXPORT jstring JNICALL Java_org_palpate_device_jni_NativeCalls_probe(JNIEnv* env, jclass,
                                                                        jstring backend,
                                                                        jint waitMillis) {
  Backend* named = palpate::backendNamed(text(env, backend));
  if (named == nullptr) {
    return nullptr;
  }
  return text(env, lines(Session::probe(*named, nanos(waitMillis))));
}

/** Returns the lines of a capture, or null with the reason in why[0]. */
JNIEXPORT jstring JNICALL Java_org_palpate_device_jni_NativeCalls_capture(
    JNIEnv* env, jclass, jstring backend, jstring id, jint waitMillis, jobjectArray why) {
  std::string reason = "no such back end";
  Backend* named = palpate::backendNamed(text(env, backend));
  const std::string lines = named != nullptr
                                ? Session::capture(*named, text(env, id), nanos(waitMillis), reason)
                                : std::string();
  if (lines.empty()) {
    env->SetObjectArrayElement(why, 0, text(env, reason));
    return nullptr;
  }
  return text(env, lines);
}

JNIEXPORT jobject JNICALL Java_org_palpate_device_jni_NativeCalls_frame(JNIEnv* env, jclass,
                                                                        jlong handle) {
  palpate::Frame* frame = Session::frame(handle);
  return frame != nullptr ? env->NewDirectByteBuffer(frame, sizeof(palpate::Frame)) : nullptr;
}

JNIEXPORT jstring JNICALL Java_org_palpate_device_jni_NativeCalls_specification(
    JNIEnv* env, jclass, jlong handle, jdoubleArray numbers) {
  const palpate::Specification specification = Session::specification(handle);
  const jdouble values[] = {
      specification.maxForceNewton,        specification.maxStiffnessNewtonPerMm,
      specification.workspaceRadiusMm,     static_cast<jdouble>(specification.reportIntervalNanos),
      specification.continuousForceNewton, specification.maxTorqueNewtonMetre};
  env->SetDoubleArrayRegion(numbers, 0, 6, values);
  std::string all;
  line(all, "name", specification.name);
  line(all, "serial", specification.serial);
  line(all, "watchdog", specification.watchdog);
  return text(env, all);
}

JNIEXPORT jint JNICALL Java_org_palpate_device_jni_NativeCalls_read(JNIEnv*, jclass, jlong handle) {
  return static_cast<jint>(Session::read(handle));
}

JNIEXPORT jboolean JNICALL Java_org_palpate_device_jni_NativeCalls_write(JNIEnv*, jclass,
                                                                         jlong handle) {
  return Session::write(handle) ? JNI_TRUE : JNI_FALSE;
}

JNIEXPORT jint JNICALL Java_org_palpate_device_jni_NativeCalls_close(JNIEnv*, jclass, jlong handle,
                                                                     jint waitMillis) {
  return static_cast<jint>(Session::close(handle, nanos(waitMillis)));
}

JNIEXPORT jstring JNICALL Java_org_palpate_device_jni_NativeCalls_ending(JNIEnv* env, jclass,
                                                                         jlong handle) {
  return text(env, Session::ending(handle));
}

JNIEXPORT jint JNICALL Java_org_palpate_device_jni_NativeCalls_underWay(JNIEnv*, jclass) {
  return Session::underWay();
}

JNIEXPORT void JNICALL Java_org_palpate_device_jni_NativeCalls_nothing(JNIEnv*, jclass) {}

}  // extern "C"
