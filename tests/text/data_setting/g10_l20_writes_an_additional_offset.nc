O1 (section 7.4: P3 is G54.1 P3)
G90 G10 L20 P3 X5. Z-1.
#100=#7041 (expect #100=5)
#101=#7043 (expect #101=-1)
M30
