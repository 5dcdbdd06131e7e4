package org.palpate.app.options;

import org.palpate.io.volume.VolumeFormatException;
import org.palpate.tool.ToolRequest;
import picocli.CommandLine.Option;

/** The options that choose the tool and its clearance. */
public final class ToolOptions {
  @Option(
      names = "--tool",
      paramLabel = "SPEC",
      description = {
        "The tool: point, sphere:R, capsule:R,L (L between the centres of its ends), cylinder:R,L,"
            + " box:A,B,C, needle:R,L (L without its round tip), or a volume file. Lengths in mm;"
            + " shapes are centred and lie along z. Default: ${DEFAULT-VALUE}."
      },
      defaultValue = "point")
  private String tool;

  @Option(
      names = "--tool-segment",
      paramLabel = "NAME=SPEC",
      description =
          "The voxels of a tool from a volume file, as in --segment. Default: tool=nonzero.")
  private String segment;

  @Option(
      names = "--points",
      paramLabel = "N",
      description = {
        "Thins the tool to at most N points. Then only these points keep clear of solids, not the"
            + " whole tool."
      })
  private Integer points;

  @Option(
      names = "--clearance",
      paramLabel = "points|body|MM",
      description = {
        "Clearance of the tool: points (no point enters a solid), body (tool and solids do not"
            + " overlap), or a margin in mm between them. A negative margin lets them overlap by"
            + " that depth. Default: body, or points with --points."
      })
  private String clearance;

  /**
   * Returns the tool that was asked for.
   *
   * @throws VolumeFormatException if an option is not understood or does not fit the others
   */
  public ToolRequest request() throws VolumeFormatException {
    return ToolRequest.parse(tool, segment, points, clearance);
  }
}
