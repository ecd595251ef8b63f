(run with: --block-skip 1)
O1 (Z-1.0/M08: the coolant is left out, the move is not)
G01 F100
Z-1.0/M08 (expect moves: line Z-1)
M60
M30
(finally records: mcode 60)
