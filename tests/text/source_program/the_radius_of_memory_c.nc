(run with: --set #13001=10 --set #12001=0.5)
O1 (section 12.5: D geometry and D wear, where memory A has one value)
#7=1
#100=#[13000+#7]+#[12000+#7] (expect #100=10.5)
#101=#[2000+#7] (expect #101=0)
M30
