package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.force.GreyMaterials;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.host.HandTargetFinder;
import org.palpate.io.GreyVolumes;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.testing.Scans;
import org.palpate.testing.Seeds;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.SegmentedVolume;

/** A hand that touches real scans whose stiffness follows from their grey values. */
class GreyTissueScanTest {
  private static final double STIFFNESS = 0.5;
  private static final double MAX_STEP_MM = 16;

  /** The largest step of the force in a frame over the stiffness times the motion of the hand. */
  private static final double MOST_STEP = 1.5;

  private static final long MS = 1_000_000;
  private static final int FRAMES = 30_000;

  /** The part of the shortest edge by which a hand at rest counts as moved in a millisecond. */
  private static final double LEAST_MOTION_EDGES = 0.05;

  private final long seed = Seeds.seed();

  @ParameterizedTest
  @CsvSource({
    "CThead/CThead_u16gz.nrrd, 1000, 1200, 2400",
    "CThead/CThead_u16gz.nrrd, 1500, 1500, 2400",
    "LIDC/LIDC-IDRI-0314_ge100HU_i16gz.nrrd, 200, 200, 900"
  })
  void noStepOfTheForceExceedsTheStiffnessTimesTheMotion(
      String file, double threshold, double soft, double hard) throws IOException {
    Path path = Scans.file(file);
    SegmentedVolume volume =
        SegmentBuilder.read(
            VolumeFiles.open(path, ReadOptions.defaults()),
            List.of(SegmentSpec.parse("tissue=>=" + threshold)));
    ScalarVolume values = GreyVolumes.read(VolumeFiles.open(path, ReadOptions.defaults()));
    GreyMaterials materials =
        new GreyMaterials(
            values,
            List.of(new GreyMaterials.Row(soft, 0.1, 0, 0), new GreyMaterials.Row(hard, 1, 0, 0)));
    GridMetric metric = GridMetric.of(volume.grid().spacingMm());
    SmoothSolver binary = new SmoothSolver(metric, MAX_STEP_MM); // with terraces and thin slices
    touch(volume, binary, materials, file + ", field of voxels");
    GreyIsosurface isosurface = GreyIsosurface.ofThreshold(values, threshold);
    SmoothSolver grey = new SmoothSolver(metric, MAX_STEP_MM, isosurface);
    touch(volume, grey, materials, file + ", field of grey values");
  }

  private void touch(
      SegmentedVolume volume, SmoothSolver solver, GreyMaterials materials, String what) {
    HapticDevice hand = new SimulatedDevice(seed, HandTargetFinder.of(volume), MS);
    GridMetric metric = GridMetric.of(volume.grid().spacingMm());
    Steps steps = new Steps(metric);
    PointFrame frame =
        new PointFrame(
            GridDevice.fromWorld(hand, volume.grid()),
            solver,
            new CollisionScene(List.of(volume.segments().get(0).bits())),
            metric,
            new FrameSettings(
                ForceSettings.of(STIFFNESS, 0),
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                0,
                FrameSettings.NO_SILENCE,
                1),
            new EditQueue(volume.grid(), 1),
            steps);
    frame.use(materials);
    for (int n = 0; n < FRAMES; n++) {
      frame.run(n * MS);
      steps.noteStiffness(frame.point().surfaceHeightMm);
    }
    String where = what + ", seed " + seed + ": " + steps;
    assertTrue(steps.softFrames > 100 && steps.hardFrames > 100, where);
    assertTrue(steps.largest <= MOST_STEP * (1 + 1e-9), where);
  }

  /** The steps of the force, and the stiffnesses that were felt. */
  private static final class Steps implements FramePublisher {
    private final GridMetric metric;
    private final Vec3 lastDevice = new Vec3();
    private final Vec3 lastForce = new Vec3();
    private double stretchMm;
    private int softFrames;
    private int hardFrames;

    /** The largest step of the force over the stiffness times the motion of the hand. */
    private double largest;

    Steps(GridMetric metric) {
      this.metric = metric;
    }

    @Override
    public void publish(Vec3 at, Vec3 point, Vec3 forceNewton, boolean contact, long frame) {
      double movedMm = metric.distance(lastDevice.x, lastDevice.y, lastDevice.z, at.x, at.y, at.z);
      double countedMm = Math.max(movedMm, LEAST_MOTION_EDGES * metric.shortestEdgeMm());
      double stepNewton = lastForce.sub(forceNewton, lastForce).length();
      if (frame > 0) {
        largest = Math.max(largest, stepNewton / (STIFFNESS * countedMm));
      }
      stretchMm = metric.distance(point.x, point.y, point.z, at.x, at.y, at.z);
      lastDevice.set(at);
      lastForce.set(forceNewton);
    }

    void noteStiffness(double surfaceHeightMm) {
      double feltMm = stretchMm - Math.max(0, surfaceHeightMm);
      double felt = lastForce.length() / (STIFFNESS * feltMm);
      softFrames += feltMm > 1 && felt < 0.4 ? 1 : 0;
      hardFrames += feltMm > 1 && felt > 0.6 ? 1 : 0;
    }

    @Override
    public String toString() {
      return "step " + largest + ", soft frames " + softFrames + ", hard frames " + hardFrames;
    }
  }
}
