O1 (section 7.4: P1 is G54, P6 is G59)
G90 G10 L2 P1 X10. Y20. Z30.
#100=#5221 (expect #100=10)
#101=#5222 (expect #101=20)
#102=#5223 (expect #102=30)
G10 L2 P6 X7.
#103=#5321 (expect #103=7)
M30
