(run with: --param V15=1)
O1 (section 3.5: #2003 is H geometry, #2203 H wear)
G10 L10 P3 R50.
G10 L11 P3 R0.5
#100=#2003 (expect #100=50)
#101=#10003 (expect #101=50)
#102=#2203 (expect #102=0.5)
#103=#11003 (expect #103=0.5)
M30
