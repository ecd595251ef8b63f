(run with: --machine lathe2)
O1 (X Z absolute and U W incremental in one block; U is a diameter)
G97S500M03
G00X60.Z5.
G01X50.W-15.F.2
U6.Z-20.
U-2.W-3.
M30
(finally moves: rapid X60 Z5; line X50 Z-10; line X56 Z-20; line X54 Z-23)
