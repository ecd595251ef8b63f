(run with: --machine lathe2)
O1 (Words)
G97S500M03
G00X50.Z5.
M98P100005
M30
O5
G00U-1.
M99
(finally machine X40)
