(run with: --set #500=3 --set #999=4)
O1 (section 2: #500 to #999 survive power off)
#100=#500+#999 (expect #100=7)
M30
