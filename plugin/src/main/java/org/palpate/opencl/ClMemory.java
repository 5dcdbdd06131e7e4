package org.palpate.opencl;

import java.nio.ByteBuffer;

/**
 * Memory of a device and its counterpart on the host.
 *
 * @param host direct, in native byte order; its position and limit mean nothing
 * @param id the driver's handle
 */
record ClMemory(ByteBuffer host, long id) {}
