O1 (section 3.5: H wear, H geometry, D wear, D geometry)
#10003=0.1
#11003=50.
#12003=0.2
#13003=5.
#100=#2003 (expect #100=0.1)
#101=#2203 (expect #101=50)
#102=#12003+#13003 (expect #102=5.2)
M30
