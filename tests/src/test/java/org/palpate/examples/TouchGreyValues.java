package org.palpate.examples;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.palpate.device.ReplayDevice;
import org.palpate.device.Trajectory;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.io.GreyVolumes;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.VoxelGrid;

/** Touches the isosurface of a CT: reads bits and grey values at once, and runs frames itself. */
public final class TouchGreyValues {
  /** Takes a file and a threshold, for example {@code scan.nrrd 250}. */
  public static void main(String[] args) throws IOException {
    double threshold = Double.parseDouble(args[1]);
    GreyVolumes.WithSegments volume =
        GreyVolumes.readWithSegments(
            VolumeFiles.open(Path.of(args[0]), ReadOptions.defaults()),
            List.of(SegmentSpec.atLeast("bone", threshold)));
    GreyIsosurface surface = GreyIsosurface.ofThreshold(volume.values(), threshold);
    ContactScene scene =
        new ContactScene(volume.segments(), ContactSettings.standard(), Optional.of(surface));

    // A device moves in world mm: here from the first corner of the volume to its centre.
    VoxelGrid grid = scene.grid();
    Trajectory trajectory = new Trajectory();
    Vec3 handMm = new Vec3();
    for (int ms = 0; ms <= 1000; ms++) {
      handMm.set(grid.sizeX(), grid.sizeY(), grid.sizeZ()).mul(ms / 2000.0, handMm);
      grid.gridToWorld(handMm, handMm);
      trajectory.add(ms, handMm.x, handMm.y, handMm.z);
    }
    ReplayDevice device = new ReplayDevice("diagonal", trajectory);

    // The frame runs in grid coordinates, and the compiler asks for a device that is converted.
    FrameSettings settings = FrameSettings.live(device.specification(), ForceSettings.of(0.5, 0));
    PointFrame frame =
        scene.newFrame(GridDevice.fromWorld(device, grid), settings, FramePublisher.NONE);
    for (long ms = 0; frame.run(ms * 1_000_000) == FrameOutcome.RUNNING; ms++) {
      if (ms % 100 == 0) {
        Vec3 pointMm = grid.gridToWorld(frame.point().position, new Vec3());
        System.out.println(pointMm + " mm: " + frame.forceNewton().length() + " N");
      }
    }
  }
}
