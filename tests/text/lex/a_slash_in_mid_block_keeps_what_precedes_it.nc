(run with: --block-skip 2)
O1 (LEX-19: only the words behind the slash are skipped)
G00 X1. /2 Y1. (expect moves: rapid X1 Y0)
M30
(finally moves: rapid X1 Y0)
