package org.palpate.app.options;

import java.util.List;
import java.util.Optional;
import org.palpate.app.process.PalpateException;
import org.palpate.geometry.Vec3;
import org.palpate.host.LiveThreshold;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.scene.GreySlices;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.MovableSlices.Mode;
import org.palpate.scene.SceneModel;
import org.palpate.volume.VoxelGrid;
import picocli.CommandLine.Option;

/** The option that shows slices of the grey values. */
public final class SliceOptions {
  private static final String MIDDLE = "middle";
  private static final String POINT = "point";

  @Option(
      names = "--slices",
      paramLabel = "I,J,K",
      description = {
        "Shows the grey values on three planes: through a voxel (-1 for no plane), through the"
            + " middle, or through the interaction point (point)."
      })
  private String slices;

  /**
   * Returns the segment whose threshold keys change: the first that was asked for by a threshold,
   * if the grey values have been read.
   */
  public static Optional<LiveThreshold.Start> threshold(VolumeSource source)
      throws VolumeFormatException {
    List<SegmentSpec> requested = source.requested();
    for (int n = 0; n < requested.size() && source.hasGreyValues(); n++) {
      if (requested.get(n).rule() instanceof SegmentSpec.Range range
          && !Double.isInfinite(range.low())) {
        GreySlices grey = new GreySlices(source.greyValues());
        return Optional.of(
            new LiveThreshold.Start(
                n, source.greyValues(), range.low(), range.high(), grey.white() - grey.black()));
      }
    }
    return Optional.empty();
  }

  boolean isRequested() {
    return slices != null;
  }

  /** Whether the slices follow the interaction point. */
  public boolean followsProxy() {
    return POINT.equals(slices);
  }

  /**
   * Reads the grey values and returns the first slices, if slices were asked for. Slices that
   * follow the interaction point start in the middle.
   */
  public Optional<MovableSlices.Start> start(VolumeSource source) throws VolumeFormatException {
    if (!isRequested()) {
      return Optional.empty();
    }
    int[] voxel = voxel(source.header().grid());
    GreySlices grey = new GreySlices(source.greyValues());
    Mode mode = followsProxy() ? Mode.AT_POINT : Mode.FIXED;
    return Optional.of(new MovableSlices.Start(grey, mode, voxel[0], voxel[1], voxel[2]));
  }

  private int[] voxel(VoxelGrid grid) {
    int[] sizes = {grid.sizeX(), grid.sizeY(), grid.sizeZ()};
    if (slices.equals(MIDDLE) || followsProxy()) {
      return new int[] {sizes[0] / 2, sizes[1] / 2, sizes[2] / 2};
    }
    String[] parts = slices.split(",", -1);
    int[] voxel = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      if (parts.length != 3 || !parts[axis].matches("-1|[0-9]{1,9}")) {
        throw wrong("write three voxel numbers, such as --slices 64,64,32, or middle, or point");
      }
      voxel[axis] = Integer.parseInt(parts[axis]);
      if (voxel[axis] >= sizes[axis]) {
        throw wrong("the volume has " + sizes[0] + " x " + sizes[1] + " x " + sizes[2] + " voxels");
      }
    }
    return voxel;
  }

  private PalpateException wrong(String remedy) {
    return PalpateException.wrongUse("the slices cannot be shown", "--slices " + slices, remedy);
  }

  /** Shows planes in a picture; those of the interaction point go through its mark. */
  public static void show(SceneModel model, VoxelGrid grid, Optional<MovableSlices.Start> start) {
    start.ifPresent(
        planes -> {
          MovableSlices shown = new MovableSlices(model, planes);
          model
              .state()
              .marks()
              .map(marks -> model.axes().toSceneOrBack(marks.point(), new Vec3()))
              .ifPresent(world -> shown.follow(grid.worldToGrid(world, world)));
        });
  }
}
