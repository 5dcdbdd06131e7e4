package org.palpate.host.placing;

import java.util.List;
import org.palpate.body.BodyGroups;
import org.palpate.force.guide.FitExchange;
import org.palpate.force.guide.FitTarget;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;

/**
 * Fits the fragment in hand to the others while a session runs, on a thread of its own. The guide
 * of the frame pulls to the newest fit.
 */
public final class FaceFitting implements AutoCloseable {
  private static final long PAUSE_NANOS = 20_000_000;

  private final ToolFrame frame;
  private final FaceFit fit;
  private final FitExchange exchange;
  private final RepeatingThread thread =
      new RepeatingThread("palpate-fit", PAUSE_NANOS, this::fitHeld, this::offerNone);
  private volatile List<RigidTransform> seen = List.of();

  /**
   * Creates a fitting that does not run yet.
   *
   * @param frame reports which body is in hand
   * @param fit belongs to the fitting from now on
   * @param exchange receives the fits; the effects of the frame take them from there
   */
  public FaceFitting(ToolFrame frame, FaceFit fit, FitExchange exchange) {
    this.frame = frame;
    this.fit = fit;
    this.exchange = exchange;
  }

  /** Starts to fit. */
  public void start() {
    thread.start();
  }

  /**
   * Takes the present poses of all bodies, from rest to present. Any thread.
   *
   * @param poses the present pose of each body, world mm; not written any more
   */
  public void see(List<RigidTransform> poses) {
    seen = poses;
  }

  private void fitHeld() {
    int held = frame.heldBody();
    List<RigidTransform> poses = seen;
    exchange.offer(held < 0 || poses.isEmpty() ? null : fit(held, poses));
  }

  private void offerNone() {
    exchange.offer(null);
  }

  private FitTarget fit(int held, List<RigidTransform> poses) {
    BodyGroups groups = frame.groups();
    List<Pose> present = poses.stream().map(pose -> new Pose().set(pose)).toList();
    return fit.fit(held, other -> groups.moveTogether(held, other), present).orElse(null);
  }

  /** Ends the fitting, and waits at most a second for a fit that is being computed. */
  @Override
  public void close() {
    thread.close();
  }
}
