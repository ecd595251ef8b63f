(run with: --machine lathe2 --block-skip 1)
O1 (Words)
G97S500M03
G00X50.Z5.
G01Z-1.0F.1/M08
M30
(finally records: spindle cw 500)
(finally machine Z-1)
