package org.palpate.imagej.dialog;

import java.util.Arrays;
import java.util.Optional;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.Workspace;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * How the reach of a real device is laid over the stack. Devices that are not real need none: their
 * positions are the stack's own.
 *
 * @param kind what is fitted
 * @param scale mm of the stack per mm of the hand, where nothing is fitted
 */
public record StackWorkspace(Kind kind, double scale) {
  /** What is fitted to the box of all segments. */
  enum Kind {
    /** One scale, so that shapes keep their proportions and all of the box is in reach. */
    FIT("fit"),
    /** A scale for each axis, so that the whole reach is used along all. */
    FIT_EACH("fit each axis"),
    /** The middle alone; the scale is given. */
    SCALE("by scale");

    private final String words;

    Kind(String words) {
      this.words = words;
    }

    /** As in the dialog. */
    @Override
    public String toString() {
      return words;
    }

    static Optional<Kind> parse(String words) {
      return Arrays.stream(values()).filter(kind -> kind.words.equals(words)).findFirst();
    }

    static String[] words() {
      return Arrays.stream(values()).map(Kind::toString).toArray(String[]::new);
    }
  }

  /** Checks the scale. */
  public StackWorkspace {
    if (!(scale > 0) || Double.isInfinite(scale)) {
      throw new IllegalArgumentException("scale must be positive and finite: scale=" + scale);
    }
  }

  /**
   * The workspace of a device over what is to be touched.
   *
   * @param target box of the segments, world mm
   */
  public Workspace of(DeviceSpecification device, HandTarget target) {
    RigidTransform axes = stackAxes();
    return switch (kind) {
      case FIT -> Workspace.fit(device, axes, target.lowMm(), target.highMm());
      case FIT_EACH -> Workspace.fitEachAxis(device, axes, target.lowMm(), target.highMm());
      case SCALE -> scaled(axes, target);
    };
  }

  private Workspace scaled(RigidTransform axes, HandTarget target) {
    Vec3 middle = target.lowMm().add(target.highMm(), new Vec3()).mul(0.5, new Vec3());
    return new Workspace(
        new RigidTransform(axes.axisX(), axes.axisY(), axes.axisZ(), middle),
        new Vec3(scale, scale, scale));
  }

  /**
   * As the stack is seen on the screen: right is right, up is against y, towards the person is
   * against z.
   */
  private static RigidTransform stackAxes() {
    return new RigidTransform(
        new Vec3(1, 0, 0), new Vec3(0, -1, 0), new Vec3(0, 0, -1), new Vec3());
  }
}
