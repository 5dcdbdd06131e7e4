package org.palpate.sync;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.Expect;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.DDD_Result;
import org.openjdk.jcstress.infra.results.DD_Result;
import org.openjdk.jcstress.infra.results.ZZ_Result;
import org.palpate.geometry.Vec3;

/**
 * Checks the values that the reader of an {@link Accumulator} can see while a writer publishes, on
 * every interleaving and compilation that jcstress tries.
 */
public final class AccumulatorJcstress {
  private AccumulatorJcstress() {}

  /** One position: three words that are written one after the other. */
  @JCStressTest
  @Outcome(id = "0.0, 0.0, 0.0", expect = Expect.ACCEPTABLE, desc = "not published yet")
  @Outcome(id = "1.0, 2.0, 3.0", expect = Expect.ACCEPTABLE, desc = "the whole position")
  @Outcome(expect = Expect.FORBIDDEN, desc = "torn")
  @State
  public static class PositionIsNeverTorn {
    private final Accumulator accumulator = new Accumulator();
    private final PositionProperty position = accumulator.position("position");

    @Actor
    public void writer() {
      position.set(1, 2, 3);
      accumulator.publish();
    }

    @Actor
    public void reader(DDD_Result result) {
      accumulator.take();
      Vec3 seen = position.read(new Vec3());
      result.r1 = seen.x;
      result.r2 = seen.y;
      result.r3 = seen.z;
    }
  }

  /** Position and force of two frames in a row. */
  @JCStressTest
  @Outcome(id = "0.0, 0.0", expect = Expect.ACCEPTABLE, desc = "before the first frame")
  @Outcome(id = "1.0, -1.0", expect = Expect.ACCEPTABLE, desc = "the first frame")
  @Outcome(id = "2.0, -2.0", expect = Expect.ACCEPTABLE, desc = "the second frame")
  @Outcome(expect = Expect.FORBIDDEN, desc = "of two frames")
  @State
  public static class PositionAndForceAreOfTheSameFrame {
    private final Accumulator accumulator = new Accumulator();
    private final PositionProperty position = accumulator.position("position");
    private final PositionProperty force = accumulator.position("force");

    @Actor
    public void writer() {
      for (int frame = 1; frame <= 2; frame++) {
        position.set(frame, 0, 0);
        force.set(0, 0, -frame);
        accumulator.publish();
      }
    }

    @Actor
    public void reader(DD_Result result) {
      accumulator.take();
      result.r1 = position.read(new Vec3()).x;
      result.r2 = force.read(new Vec3()).z;
    }
  }

  /** The value that was published before the reader came is not lost, whatever it saw meanwhile. */
  @JCStressTest
  @Outcome(id = "true, true", expect = Expect.ACCEPTABLE, desc = "the last value, and dirty once")
  @Outcome(expect = Expect.FORBIDDEN, desc = "lost, or dirty without a change")
  @State
  public static class TheLastValueIsNeverLost {
    private final Accumulator accumulator = new Accumulator();
    private final NumberProperty number = accumulator.number("number");
    private boolean wasDirty;

    @Actor
    public void writer() {
      number.set(1);
      accumulator.publish();
      number.set(2);
      accumulator.publish();
    }

    @Actor
    public void reader() {
      if (accumulator.take()) {
        wasDirty = number.read() == 2;
        number.markApplied();
      }
    }

    @Arbiter
    public void after(ZZ_Result result) {
      result.r2 = accumulator.take() != wasDirty;
      result.r1 = number.read() == 2;
    }
  }

  /** Two turns of the reader see frames in their order. */
  @JCStressTest
  @Outcome(id = "0.0, 0.0", expect = Expect.ACCEPTABLE, desc = "none yet")
  @Outcome(id = "0.0, 1.0", expect = Expect.ACCEPTABLE, desc = "none, then the first")
  @Outcome(id = "0.0, 2.0", expect = Expect.ACCEPTABLE, desc = "none, then the second")
  @Outcome(id = "1.0, 1.0", expect = Expect.ACCEPTABLE, desc = "the first twice")
  @Outcome(id = "1.0, 2.0", expect = Expect.ACCEPTABLE, desc = "one after the other")
  @Outcome(id = "2.0, 2.0", expect = Expect.ACCEPTABLE, desc = "the second twice")
  @Outcome(expect = Expect.FORBIDDEN, desc = "backwards")
  @State
  public static class FramesArriveInOrder {
    private final Accumulator accumulator = new Accumulator();
    private final NumberProperty number = accumulator.number("number");

    @Actor
    public void writer() {
      number.set(1);
      accumulator.publish();
      number.set(2);
      accumulator.publish();
    }

    @Actor
    public void reader(DD_Result result) {
      accumulator.take();
      result.r1 = number.read();
      accumulator.take();
      result.r2 = number.read();
    }
  }
}
