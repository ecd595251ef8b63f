(run with: --machine arm4)
O0001 (the block that commands the move, in the program where it stands)
G01 X200. Y100. F600.
G65 P0002 A300.
M30
O0002
#100=1
G01 X#1 (expect alarm OUT_OF_REACH at G01 X#1)
#100=2
M99
(finally #100=1)
(finally machine X200 Y100)
