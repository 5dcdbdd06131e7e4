package org.palpate.tool;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.GrownSolids;
import org.palpate.body.Mobility;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.tool.ErodedAwayException;
import org.palpate.rigid.tool.RigidTool;

/**
 * A rigid tool that was made as the user asked, and the clearance that it keeps.
 *
 * @param name the tool as it was written
 * @param tool the tool
 * @param clearance the clearance that it keeps
 * @param files the files from which it was made, which no output may replace
 * @param notes what the user should know, a sentence each
 */
public record MadeTool(
    String name, RigidTool tool, ClearanceChoice clearance, List<Path> files, List<String> notes) {

  /** Copies the lists. */
  public MadeTool {
    files = List.copyOf(files);
    notes = List.copyOf(notes);
  }

  /**
   * Returns the smallest gap that is guaranteed between the solids of tool and bodies, mm: negative
   * if they may overlap by that depth, empty in mode {@code points}.
   */
  public OptionalDouble clearanceMm() {
    return clearance.wholeBody() ? OptionalDouble.of(clearance.marginMm()) : OptionalDouble.empty();
  }

  /** Returns the clearances from bodies of which none is protected. */
  public List<Clearance> clearances(BodyScene scene) throws VolumeFormatException {
    return clearances(scene, Map.of());
  }

  /**
   * Returns the clearance from each body of a scene, in its order.
   *
   * @param protectedMm for names of bodies the margin that the tool keeps from them, mm
   * @throws VolumeFormatException if the clearance is too large for a body's voxels, or the grown
   *     solids do not fit in memory
   */
  public List<Clearance> clearances(BodyScene scene, Map<String, Double> protectedMm)
      throws VolumeFormatException {
    List<Clearance> result = new ArrayList<>();
    double bytes = 0;
    for (int n = 0; n < scene.count(); n++) {
      Body body = scene.body(n);
      Clearance ofBody = clearanceFrom(body, protectedMm.getOrDefault(body.name(), 0.0));
      bytes += bytesFor(scene.body(n), ofBody);
      result.add(ofBody);
    }
    MemoryCheck.require(bytes, "the clearance of the tool", "--tool " + name);
    return result;
  }

  /**
   * Returns the sample points of the bodies of a scene that move, which keep the same clearance
   * from each other as the tool does from them.
   *
   * @throws VolumeFormatException if nothing is left of a body that a negative margin erodes, or
   *     the sample points and grown solids do not fit in memory
   */
  public MovableShapes movableShapes(BodyScene scene) throws VolumeFormatException {
    if (!clearance.wholeBody()) {
      return MovableShapes.ofPoints(scene);
    }
    requireMemory(scene);
    try {
      return MovableShapes.ofWholeBodies(scene, clearance.marginMm());
    } catch (ErodedAwayException e) {
      throw new VolumeFormatException(
          "a body that moves has no part so deep",
          "--clearance " + NumberText.display(clearance.marginMm()),
          "choose a margin nearer to 0",
          e);
    }
  }

  private void requireMemory(BodyScene scene) throws VolumeFormatException {
    double bytes = 0;
    for (int n = 0; n < scene.count(); n++) {
      Body body = scene.body(n);
      double halfDiagonalMm = body.grid().spacingMm().length() / 2;
      bytes += bytesFor(body, new Clearance(halfDiagonalMm, halfDiagonalMm, 2));
      if (body.mobility() == Mobility.MOVABLE) {
        bytes += MovableShapes.bytesFor(body, clearance.marginMm());
      }
    }
    MemoryCheck.require(bytes, "the clearance of bodies that move", "--poses");
  }

  private Clearance clearanceFrom(Body body, double protectedMm) throws VolumeFormatException {
    Clearance ofBody = plainClearanceFrom(body, protectedMm);
    double mostMm = GrownSolids.MOST_GROWTH_EDGES * body.metric().shortestEdgeMm();
    if (ofBody.growthMm() > mostMm) {
      throw new VolumeFormatException(
          "its points would keep "
              + NumberText.display(Math.rint(1000 * ofBody.growthMm()) / 1000)
              + " mm from "
              + body.name()
              + ", more than "
              + NumberText.display(GrownSolids.MOST_GROWTH_EDGES)
              + " voxels",
          "--tool " + name,
          "choose a smaller --clearance or margin, or a tool of smaller voxels, or write"
              + " --clearance points");
    }
    return ofBody;
  }

  private Clearance plainClearanceFrom(Body body, double protectedMm) {
    double marginMm = clearance.marginMm();
    if (protectedMm > 0) {
      marginMm = Math.max(marginMm, protectedMm + Math.max(0, -marginMm)); // of the eroded tool
    }
    boolean hasNoExtent = tool.coverRadiusMm() == 0 && marginMm <= 0;
    if (clearance.wholeBody() && !hasNoExtent) {
      return Clearance.ofWholeBody(tool, body.grid(), Math.max(0, marginMm));
    }
    return protectedMm > 0 ? Clearance.ofPoints(body.grid(), protectedMm) : Clearance.POINTS;
  }

  private static double bytesFor(Body body, Clearance clearance) {
    double bytes = 0;
    for (int level = 1; clearance.growthMm() > 0 && level <= clearance.levels(); level++) {
      bytes +=
          GrownSolids.bytesFor(
              body.bits(), body.metric(), clearance.growthMm(), clearance.longestCellMm());
    }
    return bytes;
  }
}
