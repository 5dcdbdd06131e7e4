package org.palpate.rigid;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.palpate.body.BodyScene;
import org.palpate.collision.CollisionDevice;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.rigid.tool.RigidTool;

/**
 * The settings of a rigid solver.
 *
 * @param maxStepMm the most that a point may travel in one frame, w_max, positive
 * @param clearances a clearance for each body, or a single one for all
 * @param greys the grey values of each body's voxels, or none at all; entries may be null
 * @param skips whether verification skips space that is proved to be empty; the answers are the
 *     same
 * @param device judges legs; the answers are the same on every device
 */
public record RigidSettings(
    double maxStepMm,
    List<Clearance> clearances,
    List<GreyIsosurfaceSource> greys,
    boolean skips,
    CollisionDevice device) {

  /**
   * Checks the step.
   *
   * @throws IllegalArgumentException if the longest step is not positive
   */
  public RigidSettings {
    if (!(maxStepMm > 0)) {
      throw new IllegalArgumentException("maxStepMm must be positive: maxStepMm=" + maxStepMm);
    }
    clearances = List.copyOf(clearances);
    greys = Collections.unmodifiableList(new ArrayList<>(greys));
  }

  /**
   * Creates settings with which the CPU judges legs.
   *
   * @param maxStepMm the most that a point may travel in one frame, w_max, positive
   * @param clearances a clearance for each body, or a single one for all
   * @param greys the grey values of each body's voxels, or none at all; entries may be null
   * @param skips whether verification skips space that is proved to be empty
   */
  public RigidSettings(
      double maxStepMm,
      List<Clearance> clearances,
      List<GreyIsosurfaceSource> greys,
      boolean skips) {
    this(maxStepMm, clearances, greys, skips, CollisionDevice.CPU);
  }

  /**
   * {@return settings with one clearance for all bodies, whose surfaces come from their bits}
   *
   * @param maxStepMm the most that a point may travel in one frame, w_max, positive
   * @param clearance the distance that points keep from every body
   */
  public static RigidSettings of(double maxStepMm, Clearance clearance) {
    return new RigidSettings(maxStepMm, List.of(clearance), List.of(), true);
  }

  /**
   * {@return settings with the least clearance at which no solids can overlap}
   *
   * @param maxStepMm the most that a point may travel in one frame, w_max, positive
   * @param scene the bodies
   * @param tool a tool whose sample points cover its surface
   */
  public static RigidSettings ofWholeBodies(double maxStepMm, BodyScene scene, RigidTool tool) {
    List<Clearance> clearances = new ArrayList<>();
    for (int n = 0; n < scene.count(); n++) {
      clearances.add(Clearance.ofWholeBody(tool, scene.body(n).grid(), 0));
    }
    return new RigidSettings(maxStepMm, clearances, List.of(), true);
  }

  Clearance[] clearancesOf(BodyScene scene) {
    Clearance[] all = new Clearance[scene.count()];
    for (int n = 0; n < all.length; n++) {
      all[n] = clearances.get(clearances.size() == 1 ? 0 : n);
    }
    return all;
  }

  GreyIsosurfaceSource grey(int body) {
    return body < greys.size() ? greys.get(body) : null;
  }
}
