(run with: --block-skip 2)
O1 (LEX-6: N before or behind the slash, the block is skipped)
N10/2 G00 X1. (expect moves: none)
/2 N20 G00 X2. (expect moves: none)
G00 X3. (expect moves: rapid X3)
M30
