package org.palpate.opencl;

/**
 * A driver that works for a number of calls. Every later call fails: it throws, or in a driver that
 * hangs, no read ends.
 */
final class FailingDriver implements ClDriver {
  /** A way in which a call fails. */
  enum Failure {
    EXCEPTION,
    LINKAGE,
    MEMORY,
    HANGS
  }

  private final ClDriver driver;
  private final Failure failure;
  private final long last;
  private long calls;

  /**
   * Creates a driver.
   *
   * @param last the number of calls that work
   */
  FailingDriver(ClDriver driver, Failure failure, long last) {
    this.driver = driver;
    this.failure = failure;
    this.last = last;
  }

  /** Returns the number of calls. */
  long calls() {
    return calls;
  }

  private void call() {
    if (++calls <= last || failure == Failure.HANGS) {
      return;
    }
    switch (failure) {
      case LINKAGE -> throw new UnsatisfiedLinkError("no jocl");
      case MEMORY -> throw new OutOfMemoryError("direct buffer memory");
      default -> throw new IllegalStateException("CL_OUT_OF_RESOURCES");
    }
  }

  @Override
  public String name() {
    return driver.name();
  }

  @Override
  public boolean sharesProcessors() {
    return driver.sharesProcessors();
  }

  @Override
  public ClMemory allocate(long bytes) {
    call();
    return driver.allocate(bytes);
  }

  @Override
  public long kernel(String kernelName, Object... arguments) {
    call();
    return driver.kernel(kernelName, arguments);
  }

  @Override
  public void write(ClMemory memory, int bytes) {
    call();
    driver.write(memory, bytes);
  }

  @Override
  public void launch(long kernel, int items) {
    call();
    driver.launch(kernel, items);
  }

  @Override
  public void startRead(ClMemory memory, int bytes) {
    call();
    driver.startRead(memory, bytes);
  }

  @Override
  public boolean isRead() {
    call();
    return calls <= last && driver.isRead();
  }

  @Override
  public void release() {
    call();
    driver.release();
  }
}
