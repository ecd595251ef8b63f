(run with: --machine mill4 --dialect fanuc-lathe)
O1 (a machine with an axis A, and none of the name C)
G98 G00 X20. Z0.
G01 X40. A30. F100 (expect moves: line X40 A30)
M30
(finally assumed: none)
