package org.palpate.app.command;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.igtl.ReceivedImage;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

/** An image that a client sent, read as if it were a file. World axes are RAS. */
final class ReceivedVolume implements VolumeReader {
  private final ReceivedImage image;
  private final VoxelGrid grid;

  private ReceivedVolume(ReceivedImage image, VoxelGrid grid) {
    this.image = image;
    this.grid = grid;
  }

  /** Returns the volume of an image; empty if its axes are not at right angles. */
  static Optional<ReceivedVolume> of(ReceivedImage image) {
    Vec3 spacing = new Vec3(image.stepX().length(), image.stepY().length(), image.stepZ().length());
    RigidTransform axes =
        new RigidTransform(
            image.stepX().mul(1 / spacing.x, new Vec3()),
            image.stepY().mul(1 / spacing.y, new Vec3()),
            image.stepZ().mul(1 / spacing.z, new Vec3()),
            image.firstCentre());
    boolean valid =
        axes.isOrthonormal()
            && GridMetric.isValidSpacing(spacing.x)
            && GridMetric.isValidSpacing(spacing.y)
            && GridMetric.isValidSpacing(spacing.z);
    return valid
        ? Optional.of(
            new ReceivedVolume(
                image,
                VoxelGrid.ofFirstCentre(
                    image.sizeX(), image.sizeY(), image.sizeZ(), spacing, axes)))
        : Optional.empty();
  }

  @Override
  public VolumeHeader header() {
    VoxelType type = VoxelType.valueOf(image.type().name());
    return new VolumeHeader(
        "OpenIGTLink image",
        grid,
        type,
        VolumeHeader.ValueRange.of(type),
        CoordinateSystem.RAS,
        Optional.empty(),
        List.of("received over OpenIGTLink"));
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    boolean integer = header().values().isInteger();
    VoxelSlice slice = new VoxelSlice(image.sizeX(), image.sizeY(), integer);
    for (int k = 0; k < image.sizeZ(); k++) {
      int first = k * slice.count();
      for (int n = 0; n < slice.count(); n++) {
        double value = image.value(first + n);
        if (integer) {
          slice.integers()[n] = (int) value;
        } else {
          slice.doubles()[n] = value;
        }
      }
      sink.accept(k, slice);
    }
  }

  @Override
  public String sourceName() {
    return "image " + image.name();
  }

  @Override
  public List<Path> files() {
    return List.of();
  }
}
