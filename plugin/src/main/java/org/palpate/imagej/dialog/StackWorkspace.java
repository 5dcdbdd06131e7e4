package org.palpate.imagej.dialog;

import java.util.Arrays;
import java.util.Optional;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.Workspace;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Maps the workspace of a real device to the stack. Other devices need no mapping, because their
 * positions are the stack's own.
 *
 * @param kind the way of fitting
 * @param scale mm of the stack per mm of the hand, if {@code kind} is {@link Kind#SCALE}
 */
public record StackWorkspace(Kind kind, double scale) {
  /** The ways of fitting the workspace to the box of all segments. */
  public enum Kind {
    /** One scale: shapes keep their proportions, and the whole box is in reach. */
    FIT("fit"),
    /** One scale for each axis: the whole workspace is used along every axis. */
    FIT_EACH("fit each axis"),
    /** A given scale about the middle of the box. */
    SCALE("by scale");

    private final String words;

    Kind(String words) {
      this.words = words;
    }

    /** Returns the word in the dialog. */
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
   * Returns the workspace of a device over the touched region.
   *
   * @param device the specification, which gives the reach
   * @param target the box of the segments, world mm
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
   * Returns the device's axes in the stack as it appears on the screen: right is right, up is -y,
   * towards the user is -z.
   */
  private static RigidTransform stackAxes() {
    return new RigidTransform(
        new Vec3(1, 0, 0), new Vec3(0, -1, 0), new Vec3(0, 0, -1), new Vec3());
  }
}
