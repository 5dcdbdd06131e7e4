/**
 * Requests real-time scheduling, affinity, locked memory and precise sleep from Linux or Windows,
 * and reports each request as granted or denied.
 *
 * <p>Uses JNA and the kernel's text files, nothing of Palpate. Each call concerns the calling
 * thread. Nanoseconds of {@code System.nanoTime}.
 */
package org.palpate.realtime.os;
