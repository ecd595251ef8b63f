(run with: --param 6059=910)
O1 (section 6.4: G910 with three digits)
G910 S1200 H3
M30
O9019
#100=#19 (expect #100=1200)
#101=#11 (expect #101=3)
M99
