O1 (CALL-4: L is the number of passes)
G65 P2 L3 A1.
M30
O2
#100=#100+#1
M99
(finally #100=3)
