speed(10); pulse(0.4,0.1)
line(5,0)
' (finally records: power 80; power 80; line X5 Y0 Z0 F600; power 0; end)
