package org.palpate.imagej.dialog;

import java.util.Map;
import org.palpate.host.MaterialOverride;
import org.palpate.host.SolverKind;
import org.palpate.imagej.stack.SegmentColour;

/** Makes the choices of a dialog for tests that need none. */
public final class ChosenOptions {
  private ChosenOptions() {}

  /** Returns the choices for one segment "floor", until the device ends, without a window. */
  public static TouchOptions floor(
      String device, double lower, Map<String, MaterialOverride> materials) {
    return new TouchOptions(
        "floor",
        SegmentColour.BONE,
        false,
        lower,
        255,
        false,
        SolverKind.SMOOTH,
        0,
        0.2,
        new StackMaterials("", materials, Map.of()),
        device,
        new StackWorkspace(StackWorkspace.Kind.FIT, 1),
        0,
        false);
  }
}
