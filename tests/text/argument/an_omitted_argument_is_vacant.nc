O1 (ARG-6: test it with EQ #0)
G65 P2 A0
M30
O2
IF[#1EQ#0]THEN #100=1 (expect #100=null)
IF[#2EQ#0]THEN #101=1 (expect #101=1)
IF[#2EQ0]THEN #102=1 (expect #102=null)
M99
