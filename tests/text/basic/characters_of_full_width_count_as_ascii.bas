ａ＝７　＋　３
ＰＲＩＮＴ　ａ＊２
move（１０，２０）' (expect moves: rapid X10 Y20)
print "ａ"；a
' (finally prints 20)
' (finally prints ａ 10)
