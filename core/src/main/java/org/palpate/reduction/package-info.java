/**
 * Plans how a simulated hand puts the fragments of a bone back.
 *
 * <p>Uses {@code body}, {@code device}, {@code rigid.tool} and {@code raycast}. One thread. World
 * mm; poses are rest to present.
 */
package org.palpate.reduction;
