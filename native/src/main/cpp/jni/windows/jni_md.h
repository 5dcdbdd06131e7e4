#ifndef PALPATE_JNI_MD_H
#define PALPATE_JNI_MD_H

// The definitions that jni.h needs on Windows, for a cross build with another system's JDK.

#define JNIEXPORT __declspec(dllexport)
#define JNIIMPORT __declspec(dllimport)
#define JNICALL __stdcall

using jint = long;
using jlong = long long;
using jbyte = signed char;

#endif
