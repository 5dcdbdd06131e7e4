package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ValueRuleTest {

  @Test
  void atLeastAndBetweenIncludeTheirEnds() {
    assertTrue(new ValueRule.AtLeast(1500).selects(1500));
    assertFalse(new ValueRule.AtLeast(1500).selects(Math.nextDown(1500.0)));
    ValueRule soft = new ValueRule.Between(-300, 900);
    assertTrue(soft.selects(-300) && soft.selects(900));
    assertFalse(soft.selects(Math.nextDown(-300.0)) || soft.selects(Math.nextUp(900.0)));
  }

  @Test
  void aLabelIsItsWholeNumberAndNothingNear() {
    ValueRule jaws = new ValueRule.OneOf(12, 7, -8);
    assertTrue(jaws.selects(7) && jaws.selects(-8) && jaws.selects(12));
    assertFalse(jaws.selects(7.5) || jaws.selects(0) || jaws.selects(8));
  }

  @Test
  void nonZeroTakesBothSignsAndNoZero() {
    ValueRule all = new ValueRule.NonZero();
    assertTrue(all.selects(-1) && all.selects(Double.MIN_VALUE));
    assertFalse(all.selects(0.0) || all.selects(-0.0));
  }

  @Test
  void nanBelongsToNoSegment() {
    ValueRule[] rules = {
      new ValueRule.AtLeast(Double.NEGATIVE_INFINITY),
      new ValueRule.Between(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY),
      new ValueRule.NonZero(),
      new ValueRule.OneOf(0)
    };
    for (ValueRule rule : rules) {
      assertEquals(false, rule.selects(Double.NaN), rule.toString());
    }
  }
}
