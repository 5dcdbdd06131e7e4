package org.palpate.opencl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.common.nio.PointerBuffer;
import com.jogamp.opencl.CLBuffer;
import com.jogamp.opencl.CLCommandQueue;
import com.jogamp.opencl.CLContext;
import com.jogamp.opencl.CLException;
import com.jogamp.opencl.CLKernel;
import com.jogamp.opencl.CLMemory.Mem;
import com.jogamp.opencl.CLProgram;
import com.jogamp.opencl.llb.CL;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Calls OpenCL through JOCL. Calls in a frame use its low-level binding, because the high-level one
 * allocates.
 */
final class JoclDriver implements ClDriver {
  /** Work items of a group: a multiple of what every GPU runs at once. */
  private static final int GROUP = 64;

  private final String name;
  private final boolean sharesProcessors;
  private final CLContext context;
  private final CLProgram program;
  private final CL cl;
  private final long queue;
  private final PointerBuffer globalSize = PointerBuffer.allocateDirect(1);
  private final PointerBuffer groupSize = PointerBuffer.allocateDirect(1);
  private final PointerBuffer event = PointerBuffer.allocateDirect(1);
  private final IntBuffer status = Buffers.newDirectIntBuffer(1);

  /** Everything that the device may still read or write; JOCL frees nothing by itself. */
  private final List<Object> kept = new ArrayList<>();

  /** Compiles the kernels for a device. */
  JoclDriver(JoclDevices.Found found) {
    this(found, source());
  }

  /** Compiles other kernels than those of the product. */
  JoclDriver(JoclDevices.Found found, String source) {
    name = found.entry().name();
    sharesProcessors = !found.entry().isGpu();
    context = CLContext.create(found.device());
    try {
      program = context.createProgram(source).build();
      CLCommandQueue made = context.getDevices()[0].createCommandQueue();
      kept.add(made);
      queue = made.ID;
      cl = context.getCL();
      groupSize.put(0, GROUP);
    } catch (RuntimeException | LinkageError e) {
      context.release();
      throw e;
    }
  }

  /** Returns the source of the kernels. */
  static String source() {
    try (InputStream in = JoclDriver.class.getResourceAsStream("legs.cl")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public boolean sharesProcessors() {
    return sharesProcessors;
  }

  @Override
  public ClMemory allocate(long bytes) {
    if (bytes > Integer.MAX_VALUE) {
      throw new IllegalArgumentException("one buffer holds less than 2 GiB: bytes=" + bytes);
    }
    ByteBuffer host = Buffers.newDirectByteBuffer((int) bytes);
    CLBuffer<ByteBuffer> made = context.createBuffer(host, Mem.READ_WRITE);
    kept.add(made);
    return new ClMemory(host, made.ID);
  }

  @Override
  public long kernel(String kernelName, Object... arguments) {
    CLKernel made = program.createCLKernel(kernelName);
    kept.add(made);
    for (int n = 0; n < arguments.length; n++) {
      if (arguments[n] instanceof ClMemory memory) {
        made.setArg(n, bufferOf(memory));
      } else {
        made.setArg(n, (Integer) arguments[n]);
      }
    }
    return made.ID;
  }

  private CLBuffer<?> bufferOf(ClMemory memory) {
    return kept.stream()
        .filter(each -> each instanceof CLBuffer<?> buffer && buffer.ID == memory.id())
        .map(each -> (CLBuffer<?>) each)
        .findFirst()
        .orElseThrow();
  }

  @Override
  public void write(ClMemory memory, int bytes) {
    check(
        cl.clEnqueueWriteBuffer(
            queue, memory.id(), CL.CL_FALSE, 0, bytes, memory.host(), 0, null, null),
        "a copy to the device");
  }

  @Override
  public void launch(long kernel, int items) {
    globalSize.put(0, (items + (GROUP - 1L)) / GROUP * GROUP);
    check(
        cl.clEnqueueNDRangeKernel(queue, kernel, 1, null, globalSize, groupSize, 0, null, null),
        "a launch");
  }

  @Override
  public void startRead(ClMemory memory, int bytes) {
    check(
        cl.clEnqueueReadBuffer(
            queue, memory.id(), CL.CL_FALSE, 0, bytes, memory.host(), 0, null, event),
        "a copy from the device");
    check(cl.clFlush(queue), "sending the calls");
  }

  @Override
  public boolean isRead() {
    check(
        cl.clGetEventInfo(
            event.get(0), CL.CL_EVENT_COMMAND_EXECUTION_STATUS, Integer.BYTES, status, null),
        "asking for the state");
    if (status.get(0) > CL.CL_COMPLETE) {
      return false;
    }
    check(cl.clReleaseEvent(event.get(0)), "freeing an event");
    check(status.get(0), "the work of the device");
    return true;
  }

  private static void check(int result, String what) {
    if (result != CL.CL_SUCCESS) {
      throw new IllegalStateException(what + " failed: " + CLException.resolveErrorCode(result));
    }
  }

  @Override
  public void release() {
    context.release();
  }
}
