/**
 * Plans how a simulated hand puts the fragments of a bone back. {@link
 * org.palpate.reduction.Disassembly} finds the order and the ways by taking them apart.
 *
 * <p>Uses {@code rigid} and {@code device}. One thread. World mm; poses are rest to present.
 */
package org.palpate.reduction;
