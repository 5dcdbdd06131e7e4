package org.palpate.app.options;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.io.file.NumberText;
import org.palpate.io.label.SegmentProposal;
import org.palpate.io.label.ValueStatistics;
import org.palpate.volume.phantom.Phantom;

/** Words the segments that a user may try for the values of a volume. */
final class SegmentSuggestion {
  private final Optional<Phantom> phantom;

  /**
   * Creates suggestions.
   *
   * @param phantom the phantom that the volume is, whose thresholds are known
   */
  SegmentSuggestion(Optional<Phantom> phantom) {
    this.phantom = phantom;
  }

  /** Returns arguments for the user to try. */
  String arguments(ValueStatistics.Summary found) {
    List<String> arguments = new ArrayList<>();
    if (phantom.isPresent()) {
      phantom
          .get()
          .thresholds()
          .forEach(t -> arguments.add(argument(t.name(), rounded(t.atLeast()))));
    } else {
      SegmentProposal.of(found)
          .forEach(
              proposal ->
                  arguments.add(
                      argument(
                          proposal.name(),
                          proposal.isExact() ? proposal.atLeast() : rounded(proposal.atLeast()))));
    }
    return arguments.isEmpty() ? "--segment all=nonzero" : String.join(" or ", arguments);
  }

  /** Returns the reason for the arguments in brackets; empty for a phantom. */
  String reason(ValueStatistics.Summary found) {
    String reason = phantom.isPresent() ? "" : SegmentProposal.reason(found);
    return reason.isEmpty() ? "" : " (" + reason + ")";
  }

  private static String argument(String name, double atLeast) {
    return String.format(Locale.ROOT, "--segment '%s=>=%s'", name, NumberText.display(atLeast));
  }

  /** Rounds to three digits, because a threshold is only a suggestion. */
  private static double rounded(double value) {
    if (value == 0) {
      return 0;
    }
    double unit = Math.pow(10, Math.floor(Math.log10(Math.abs(value))) - 2);
    return unit >= 1 ? Math.rint(value / unit) * unit : Math.rint(value * (1 / unit)) / (1 / unit);
  }
}
