O1 (REF-2: G30 and G30 P2 end at the same point)
G91 G30 X0
#100=#5021
G90 G00 X50.
G91 G30 P2 X0
#101=#5021-#100 (expect #101=0)
M30
