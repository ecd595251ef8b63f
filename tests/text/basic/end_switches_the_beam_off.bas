speed(10);power(50)
line(1,0)
end
line(2,0)
' (finally records: power 50; line X1 Y0 Z0 F600; power 0; end)
' (finally counts line 1)
