O1 (NUL-8: A#1 with #1 vacant)
G65 P2 A#1 B2.
M30
O2
IF[#1EQ#0]THEN #100=1 (expect #100=1)
#101=#2 (expect #101=2)
M99
